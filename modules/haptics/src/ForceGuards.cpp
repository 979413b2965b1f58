#include "pellucida/haptics/ForceGuards.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {

bool is_finite(const Eigen::Vector3d& v) noexcept {
  return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

Eigen::Vector3d low_pass(const Eigen::Vector3d& previous, const Eigen::Vector3d& wanted, double cutoff_Hz,
                         double dt_s) noexcept {
  const double time_constant_s = 1.0 / (2.0 * std::numbers::pi * cutoff_Hz);
  return previous + dt_s / (dt_s + time_constant_s) * (wanted - previous);
}

Eigen::Vector3d limit_change(const Eigen::Vector3d& previous, const Eigen::Vector3d& wanted,
                             double max_change) noexcept {
  return previous + saturate(wanted - previous, max_change);
}

Eigen::Vector3d saturate(const Eigen::Vector3d& wanted, double limit) noexcept {
  const double length = wanted.norm();
  if (length <= limit) return wanted;
  return wanted * (limit / length);
}

double smooth_step(double x) noexcept {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double Ramp::step(double goal, double time_s, double dt_s) noexcept {
  const double most = time_s > 0.0 ? dt_s / time_s : 1.0;
  value_ += std::clamp(goal - value_, -most, most);
  return value_;
}

}  // namespace pellucida
