#include "pellucida/haptics/PassivityObserver.h"

#include <algorithm>

namespace pellucida {

PassivityObserver::PassivityObserver(const DeviceSpecification& device, double period_s) noexcept
    : credited_damping_(device.physical_damping_N_s_per_m > 0.0 ? device.physical_damping_N_s_per_m
                                                                : 0.5 * device.max_stiffness_N_per_m * period_s),
      max_damping_(device.max_damping_N_s_per_m),
      largest_margin_J_(device.max_stiffness_N_per_m > 0.0
                            ? 5.0 * device.max_force_N * device.max_force_N / device.max_stiffness_N_per_m
                            : 0.0) {}

void PassivityObserver::rebase(const Eigen::Vector3d& hand_m) noexcept {
  hand_m_ = hand_m;
  started_ = true;
}

void PassivityObserver::observe(const Eigen::Vector3d& hand_m, const Eigen::Vector3d& last_force_N,
                                double dt_s) noexcept {
  if (!started_) {
    rebase(hand_m);
    return;
  }
  const Eigen::Vector3d way_m = hand_m - hand_m_;
  hand_m_ = hand_m;
  if (dt_s <= 0.0) return;
  margin_J_ += -last_force_N.dot(way_m) + credited_damping_ * way_m.squaredNorm() / dt_s;
  margin_J_ = std::min(margin_J_, largest_margin_J_);
}

Eigen::Vector3d PassivityObserver::damping_force_N(const Eigen::Vector3d& velocity_m_per_s, double dt_s) noexcept {
  const double speed_squared = velocity_m_per_s.squaredNorm();
  double wanted = 0.0;
  if (margin_J_ < 0.0 && dt_s > 0.0 && speed_squared > 0.0) wanted = -margin_J_ / (dt_s * speed_squared);
  const double goal = max_damping_ > 0.0 ? std::min(1.0, wanted / max_damping_) : 0.0;
  // A damper that came at once would be a knock.
  constexpr double kOnset_s = 0.01;
  return -alpha_part_.step(goal, kOnset_s, dt_s) * max_damping_ * velocity_m_per_s;
}

}  // namespace pellucida
