#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

#include "pellucida/core/ContactModel.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

/// What tracking and mechanics make of a frame, as far as the hand can tell: rate, delay and errors as they were
/// measured on the virtual microscope (docs/method.md).
struct ContactCameraOptions {
  double frame_rate_hz = 30.0;
  double delay_s = 0.04;               ///< from the exposure to the measured force
  double depth_sigma_um = 0.1;         ///< of the indentation
  double force_relative_sigma = 0.03;  ///< of a cell's force scale, drawn once
  double tip_sigma_um = 0.1;           ///< of the tip, in each direction of the image
  std::uint64_t seed = 1;
};

/// The vision chain in short, for thousands of trials: looks at the specimen at the frame rate and hands out contact
/// models a delay later, with the errors that vision has. Not a substitute for the chain where the chain itself is
/// judged. Deterministic by its seed; allocates nothing after construction.
class ContactCamera {
 public:
  /// `cell`: the resting cell and its needle's direction, for the models. Throws UsageError for a rate, a delay or a
  /// sigma out of range (more than 16 frames under way).
  ContactCamera(const ContactCameraOptions& options, const SpecimenForce& cell, double outer_radius_um);

  /// Time goes on to `now_s` with the specimen as it is; true when a measured frame lands, which is `newest` then.
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
