#include "pellucida/haptics/HandMotion.h"

#include <algorithm>
#include <cmath>

#include "pellucida/haptics/ForceGuards.h"

namespace pellucida {
namespace {

constexpr double kUsualResolution_m = 1e-5;
constexpr double kSlack_m = 1e-3;

}  // namespace

HandVelocity::HandVelocity(double resolution_m) noexcept
    : resolution_m_(resolution_m > 0.0 ? resolution_m : kUsualResolution_m) {}

double HandVelocity::axis_speed(int axis) const noexcept {
  const std::size_t kept = std::min(count_, kCapacity);
  const Reading& newest = back(0);
  double speed = 0.0;
  // Longer and longer windows, until a reading within is off the line between the ends.
  for (std::size_t length = 1; length < kept; ++length) {
    const Reading& oldest = back(length);
    const double candidate = (newest.axis_m[axis] - oldest.axis_m[axis]) / (newest.time_s - oldest.time_s);
    for (std::size_t k = 1; k < length; ++k) {
      const double on_line = newest.axis_m[axis] - candidate * (newest.time_s - back(k).time_s);
      if (std::abs(back(k).axis_m[axis] - on_line) > resolution_m_) return speed;
    }
    speed = candidate;
  }
  return speed;
}

Eigen::Vector3d HandVelocity::update(double time_s, const Eigen::Vector3d& position_m) noexcept {
  if (count_ == 0 || time_s > back(0).time_s) {
    Reading& reading = readings_[count_ & (kCapacity - 1)];
    reading.time_s = time_s;
    for (int axis = 0; axis < 3; ++axis) reading.axis_m[axis] = position_m[axis];
    ++count_;
  }
  return {axis_speed(0), axis_speed(1), axis_speed(2)};
}

HandReading HandGuard::check(const HandSample& sample, double dt_s, double max_speed_m_per_s) noexcept {
  since_s_ += dt_s;
  const Eigen::Vector3d position_m = sample.position_m.eigen();
  if (!is_finite(position_m) || (sample.velocity_known && !is_finite(sample.velocity_m_per_s.eigen()))) {
    return HandReading::kNotFinite;
  }
  const bool jump = known_ && (position_m - last_m_).norm() > max_speed_m_per_s * since_s_ + kSlack_m;
  last_m_ = position_m;
  since_s_ = 0.0;
  known_ = true;
  return jump ? HandReading::kJump : HandReading::kGood;
}

}  // namespace pellucida
