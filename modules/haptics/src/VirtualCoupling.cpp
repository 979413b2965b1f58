#include "pellucida/haptics/VirtualCoupling.h"

#include <algorithm>

namespace pellucida {

VirtualCoupling::VirtualCoupling(const CouplingSettings& settings, const DeviceSpecification& device) noexcept
    : device_force_N_(device.max_force_N),
      device_stiffness_N_per_m_(device.max_stiffness_N_per_m),
      device_damping_N_s_per_m_(device.max_damping_N_s_per_m) {
  set(settings);
}

void VirtualCoupling::set(const CouplingSettings& settings) noexcept {
  settings_ = settings;
  settings_.stiffness_N_per_m = std::clamp(settings.stiffness_N_per_m, 0.0, device_stiffness_N_per_m_);
  settings_.damping_N_s_per_m = std::clamp(settings.damping_N_s_per_m, 0.0, device_damping_N_s_per_m_);
  settings_.max_force_N = std::clamp(settings.max_force_N, 0.0, device_force_N_);
}

Eigen::Vector3d VirtualCoupling::force_N(const Eigen::Vector3d& proxy_um, const Eigen::Vector3d& wanted_um,
                                         const Eigen::Vector3d& relative_velocity_um_per_s,
                                         double scale_um_per_m) const noexcept {
  const Eigen::Vector3d lag_um = proxy_um - wanted_um;
  const double lag = lag_um.norm();
  if (lag <= 0.0) return Eigen::Vector3d::Zero();
  const double weight = settings_.width_um > 0.0 ? smooth_step(lag / settings_.width_um) : 1.0;
  // The damper works along the link only: across it, nothing is stretched.
  const Eigen::Vector3d along = lag_um / lag;
  const double rate_um_per_s = relative_velocity_um_per_s.dot(along);
  return saturate(
      (settings_.stiffness_N_per_m * lag_um + settings_.damping_N_s_per_m * weight * rate_um_per_s * along) /
          scale_um_per_m,
      settings_.max_force_N);
}

double VirtualCoupling::force_scale_N_per_uN(double wanted_N_per_uN, double stiffness_uN_per_um, double scale_um_per_m,
                                             double dt_s) noexcept {
  const double stiffness_N_per_m = wanted_N_per_uN * stiffness_uN_per_um * scale_um_per_m;
  const double goal =
      stiffness_N_per_m > device_stiffness_N_per_m_ ? device_stiffness_N_per_m_ / stiffness_N_per_m : 1.0;
  constexpr double kDownTime_s = 0.1, kUpTime_s = 1.0;
  return wanted_N_per_uN * part_.step(goal, goal < part_.value() ? kDownTime_s : kUpTime_s, dt_s);
}

}  // namespace pellucida
