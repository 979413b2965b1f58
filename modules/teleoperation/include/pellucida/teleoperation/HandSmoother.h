#pragma once
#include <Eigen/Core>
#include <cmath>

namespace pellucida {

/// Makes a smooth path of readings that arrive in steps: a mouse, a gamepad or a wheel reports motion 60 to 250 times a
/// second, the loop reads 1000 times. First-order lag of 10 ms, never faster than 1 m/s: a step becomes a fast move.
/// Neither allocates nor throws.
class HandSmoother {
 public:
  static constexpr double kLag_s = 0.010;
  static constexpr double kMaxSpeed_m_per_s = 1.0;

  void reset(const Eigen::Vector3d& position_m) noexcept {
    position_m_ = position_m;
    velocity_m_per_s_.setZero();
  }

  /// Towards `goal_m` for `dt_s`; with 0 or less nothing moves.
  void update(const Eigen::Vector3d& goal_m, double dt_s) noexcept {
    if (!(dt_s > 0.0) || !goal_m.allFinite()) return;
    Eigen::Vector3d step_m = (goal_m - position_m_) * (1.0 - std::exp(-dt_s / kLag_s));
    const double length_m = step_m.norm();
    const double longest_m = kMaxSpeed_m_per_s * dt_s;
    if (length_m > longest_m) step_m *= longest_m / length_m;
    position_m_ += step_m;
    velocity_m_per_s_ = step_m / dt_s;
  }

  const Eigen::Vector3d& position_m() const noexcept { return position_m_; }
  const Eigen::Vector3d& velocity_m_per_s() const noexcept { return velocity_m_per_s_; }

 private:
  Eigen::Vector3d position_m_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_m_per_s_ = Eigen::Vector3d::Zero();
};

}  // namespace pellucida
