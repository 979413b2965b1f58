#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "pellucida/core/ContactModel.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

/// The result of tracking and mechanics for a frame, as far as the hand is concerned. The errors are those of the
/// default virtual microscope in docs/method.md, Validation: indentation 0.10 um RMS, force within 3 % of the peak, tip
/// 0.11 px of 0.825 um. The delay is a little above its time from frame to force (median 18 ms, 99 % 47 ms) with a
/// camera's own.
struct ContactCameraOptions {
  double frame_rate_hz = 30.0;         ///< above 0
  double delay_s = 0.04;               ///< from the exposure to the measured force; 0 to 15 frames
  double depth_sigma_um = 0.1;         ///< of the indentation, a frame
  double force_relative_sigma = 0.03;  ///< of a cell's force scale, drawn once
  double tip_sigma_um = 0.1;           ///< of the tip, in each direction of the image, a frame
  std::uint64_t seed = 1;
};

/// The vision chain without images, for thousands of trials: samples the specimen at the frame rate and delivers
/// contact models after a delay, with the errors of vision. The tip's distance from the image plane is taken from the
/// manipulator, without error. Not a substitute for the chain where the chain itself is assessed: it never loses the
/// cell. Deterministic by its seed; allocates nothing after construction.
class ContactCamera {
 public:
  /// `cell`: the resting cell and its needle's direction. Throws UsageError for a rate, delay or sigma out of range.
  ContactCamera(const ContactCameraOptions& options, const SpecimenForce& cell);

  /// Advances to `now_s` (never back) with the specimen as it is; true when a measured frame arrives, which is then
  /// `newest`. A frame is exposed at the first call at or after its time.
  bool look(const SpecimenMoment& moment, double now_s) noexcept;
  const ContactModel& newest() const noexcept { return newest_; }

 private:
  static constexpr std::size_t kUnderWay = 16;
  struct Frame {
    double due_s = 0.0;
    ContactModel model;
  };
  ContactModel measured(const SpecimenMoment& moment, double now_s) noexcept;

  ContactCameraOptions options_;
  SpecimenForce cell_;
  double outer_radius_um_;
  double scale_ = 1.0;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::array<Frame, kUnderWay> under_way_{};
  std::size_t first_ = 0, count_ = 0;
  double next_s_ = 0.0;
  bool started_ = false;
  long frame_index_ = 0;
  ContactModel newest_;
};

}  // namespace pellucida
