#pragma once
#include <Eigen/Core>
#include <array>

#include "pellucida/core/PlainVector.h"
#include "pellucida/simulation/NormalNoise.h"
#include "pellucida/simulation/OperatorOptions.h"

namespace pellucida {

/// A simulated operator's motor control: minimum-jerk submovements
///
///     x(t) = A (10 u^3 - 15 u^4 + 6 u^5),  u = t/D        Flash and Hogan, J. Neurosci. 5 (1985)
///
/// that overlap (Flash and Henis, J. Cogn. Neurosci. 3 (1991)). Frame H, m. One step a millisecond; nothing allocates
/// or throws.
class OperatorMotion {
 public:
  OperatorMotion(const OperatorOptions& options, double scale_um_per_m) noexcept;

  /// A submovement from now on, by `way_um` of the tip (frame W), in Fitts' time or longer; its length has the noise,
  /// not its start.
  void aim(const Eigen::Vector3d& way_um, double least_duration_s, double now_s, NormalNoise& noise) noexcept;
  /// The submovements under way end at once; what speed they had fades.
  void halt() noexcept;

  /// The millisecond from `now_s` on.
  void step(double now_s) noexcept;

  const PlainVector3& position_m() const noexcept { return position_m_; }
  const PlainVector3& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }
  /// Where the hand will be when all is done that is under way.
  Eigen::Vector3d end_m() const noexcept;
  /// Where it was to be so long before the newest step; the start for a time before it.
  PlainVector3 position_before_m(double lag_s) const noexcept;
  int submovement_count() const noexcept { return submovement_count_; }

 private:
  struct Submovement {
    double start_s = 0.0, duration_s = 0.0;
    PlainVector3 way_m;
  };

  OperatorOptions options_;
  double scale_um_per_m_;
  PlainVector3 base_m_, drift_m_per_s_;  ///< ended submovements; what is left of a halted one's speed
  std::array<Submovement, 16> moves_{};
  int move_count_ = 0, submovement_count_ = 0;
  PlainVector3 position_m_, velocity_m_per_s_;
  long step_count_ = 0;
  std::array<PlainVector3, 512> past_m_{};  ///< ring, one a step
};

/// Tremor: white noise through two poles at its frequency. RMS of the vector as in the options. Frame H, m. Nothing
/// allocates or throws.
class OperatorTremor {
 public:
  OperatorTremor(const OperatorOptions& options, NormalNoise& noise) noexcept;

  /// The next millisecond.
  void step(NormalNoise& noise) noexcept;
  const PlainVector3& position_m() const noexcept { return state_[0]; }

 private:
  double pole_, turn_, gain_m_;
  std::array<PlainVector3, 2> state_{};
};

}  // namespace pellucida
