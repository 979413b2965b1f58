#include "haptics/SimulatedArm.h"

#include <cmath>
#include <limits>

namespace pellucida::test {

SimulatedArm::SimulatedArm(DeviceSpecification specification, const ArmOptions& arm)
    : specification_(std::move(specification)), arm_(arm) {
  // A maker's largest stiffness claims b >= K T / 2 at 1 kHz.
  damping_ = arm.damping_N_s_per_m + 0.5e-3 * specification_.max_stiffness_N_per_m;
}

bool SimulatedArm::read(double now_s, HandSample& sample) noexcept {
  if (lost) return false;
  sample = HandSample{};
  sample.time_s = now_s;
  Eigen::Vector3d seen = position_m_ + jump_m;
  // The encoder's steps.
  const double step_m = specification_.resolution_m;
  if (step_m > 0.0) seen = (seen / step_m).array().round() * step_m;
  sample.position_m = seen;
  if (says_nan) sample.position_m.y = std::numeric_limits<double>::quiet_NaN();
  sample.buttons = buttons;
  return true;
}

bool SimulatedArm::write(const PlainVector3& force_N) noexcept {
  if (lost) {
    // Without power the motors give nothing.
    force_N_.setZero();
    return false;
  }
  force_N_ = force_N.eigen();
  return true;
}

void SimulatedArm::advance(double dt_s) noexcept {
  constexpr int kParts = 20;
  const double part_s = dt_s / kParts;
  for (int k = 0; k < kParts; ++k) {
    const Eigen::Vector3d force_N =
        arm_.stiffness_N_per_m * (intent_m - position_m_) - damping_ * velocity_m_per_s_ + force_N_;
    velocity_m_per_s_ += part_s / arm_.mass_kg * force_N;
    position_m_ += part_s * velocity_m_per_s_;
  }
}

}  // namespace pellucida::test
