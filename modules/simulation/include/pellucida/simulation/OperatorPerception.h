#pragma once
#include <Eigen/Core>
#include <array>
#include <optional>
#include <type_traits>

#include "pellucida/core/PlainVector.h"
#include "pellucida/simulation/NormalNoise.h"
#include "pellucida/simulation/OperatorOptions.h"

namespace pellucida {

/// What the operator is shown at one moment: once per image, on the run's clock. Trivially copyable.
struct OperatorView {
  double time_s = -1.0;
  PlainVector3 tip_um;  ///< the tip in the image; frame W
  bool tip_seen = false;
  bool membrane_closed = false;  ///< the image shows the membrane broken and closed around the shaft
};
static_assert(std::is_trivially_copyable_v<OperatorView>);

/// What a simulated operator sees and feels: images a visual reaction time late, with a visual error by modality that
/// changes slowly from glance to glance; the resistance against the line of entry a haptic reaction time late. Tremor
/// is not taken for a force: touch follows slow changes. Nothing allocates or throws.
class OperatorPerception {
 public:
  /// An image, and where the hand was to be when the tip went where the image shows it (frame H, m).
  struct Seen {
    OperatorView view;
    PlainVector3 intended_m;
  };

  /// `against`: unit vector against the line of entry, frame H; zero where there is none.
  OperatorPerception(const OperatorOptions& options, const PlainVector3& against, NormalNoise& noise) noexcept;

  void see(const OperatorView& view, const PlainVector3& intended_m) noexcept;
  /// The newest image that has been taken in by `time_s`; nothing where it doesn't show the tip.
  std::optional<Seen> newest(double time_s) const noexcept;
  /// One glance at an image: where the tip is seen, um; with its error.
  Eigen::Vector3d look(const Seen& seen, NormalNoise& noise) noexcept;
  /// The error's standard deviation, um.
  Eigen::Vector3d noise_um() const noexcept;

  /// The next millisecond with the force on the hand. While the operator `attends` to it: true when the force rose and
  /// then fell, as when a membrane gives way.
  bool feel(const PlainVector3& force_N, bool attends) noexcept;
  /// The resistance felt a reaction time ago; 0 while the operator doesn't attend to it.
  double resistance_N() const noexcept { return felt_late_N_; }

 private:
  OperatorOptions options_;
  bool haptics_;
  double depth_noise_um_;
  PlainVector3 against_;

  std::array<Seen, 64> seen_{};
  int seen_count_ = 0, seen_next_ = 0;
  PlainVector3 sight_error_;  ///< of the last look, in its standard deviations

  long tick_ = 0;
  std::array<double, 512> felt_N_{};  ///< ring, one a tick
  double felt_now_N_ = 0.0, felt_late_N_ = 0.0, felt_peak_N_ = 0.0;
};

}  // namespace pellucida
