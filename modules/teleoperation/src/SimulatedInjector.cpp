#include "pellucida/teleoperation/SimulatedInjector.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kLongestStep_s = 0.001;
constexpr double kBrakingShare = 0.9;  // of the acceleration: braking begins a little early

/// The speed from which discrete steps of braking still end on the spot, `way_um` ahead: v^2 / (2 a) + v dt / 2 = way.
double braking_speed(double way_um, double acceleration, double dt_s) noexcept {
  const double a = kBrakingShare * acceleration;
  return a * (std::sqrt(dt_s * dt_s / 4.0 + 2.0 * way_um / a) - dt_s / 2.0);
}

double rounded(double value, double step) noexcept {
  return step > 0.0 ? std::round(value / step) * step : value;
}

Eigen::Vector3d rounded(const Eigen::Vector3d& value, double step) noexcept {
  return {rounded(value.x(), step), rounded(value.y(), step), rounded(value.z(), step)};
}

void check(const SimulatedInjectorOptions& o) {
  const Eigen::Array3d lower = o.lower_um.eigen(), upper = o.upper_um.eigen(), start = o.start_um.eigen();
  if (!(lower < upper).all())
    throw UsageError("simulated injector: each lower travel limit must be below the upper one");
  if (!((lower <= start).all() && (start <= upper).all())) {
    throw UsageError("simulated injector: the start must lie within the travel limits");
  }
  for (const double value : {o.max_speed_um_per_s, o.max_acceleration_um_per_s2}) {
    if (!(value > 0.0) || !std::isfinite(value)) {
      throw UsageError("simulated injector: speed and acceleration must be above 0, not " + std::to_string(value));
    }
  }
  for (const double value : {o.backlash_um, o.resolution_um, o.latency_s, o.deposit_rate_pl_per_s}) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
      throw UsageError("simulated injector: backlash, resolution, latency and deposit rate must be 0 or above, not " +
                       std::to_string(value));
    }
  }
}

}  // namespace

SimulatedInjector::SimulatedInjector(const SimulatedInjectorOptions& options, Follower follower)
    : options_(options), follower_(std::move(follower)), motor_um_(options.start_um.eigen()), target_um_(motor_um_) {
  check(options);
  specification_.name = "simulated injector";
  specification_.lower_um = options.lower_um;
  specification_.upper_um = options.upper_um;
  specification_.max_speed_um_per_s = options.max_speed_um_per_s;
  specification_.resolution_um = options.resolution_um;
  specification_.can_inject = true;
  specification_.source = "chosen";
  pose_.tip_um = options.start_um;
}

void SimulatedInjector::open() {
  open_ = true;
}

void SimulatedInjector::close() noexcept {
  hold();
  waiting_.clear();
  open_ = false;
}

void SimulatedInjector::hold() {
  target_um_ = motor_um_;
  velocity_um_per_s_.setZero();
  speed_limit_um_per_s_ = 0.0;
  injecting_ = false;
  target_clamped_ = false;
}

void SimulatedInjector::command(const PipetteCommand& command, double now_s) {
  if (!open_) throw DeviceError("simulated injector: not open; open it before commanding it");
  follow_time(now_s);
  if (command.stop) {
    hold();
    waiting_.clear();
    stopped_ = true;
    return;
  }
  waiting_.push_back({time_s_ + options_.latency_s, command});
  take_due_commands();
}

void SimulatedInjector::take_due_commands() {
  auto next = waiting_.begin();
  for (; next != waiting_.end() && next->due_s <= time_s_; ++next) {
    const PipetteCommand& command = next->command;
    const Eigen::Vector3d wished_um = rounded(command.tip_um.eigen(), options_.resolution_um);
    target_um_ = wished_um.cwiseMax(options_.lower_um.eigen()).cwiseMin(options_.upper_um.eigen());
    target_clamped_ = target_um_ != wished_um;
    speed_limit_um_per_s_ = std::clamp(command.max_speed_um_per_s, 0.0, options_.max_speed_um_per_s);
    injecting_ = command.inject;
    stopped_ = false;
  }
  waiting_.erase(waiting_.begin(), next);
}

void SimulatedInjector::follow_time(double now_s) {
  if (!time_known_) {
    time_s_ = now_s;
    time_known_ = true;
  } else if (now_s > time_s_) {
    advance(now_s - time_s_);
  }
}

void SimulatedInjector::advance(double dt_s) {
  if (!(dt_s > 0.0)) return;
  time_known_ = true;
  const double end_s = time_s_ + dt_s;
  while (time_s_ < end_s) {
    const bool nothing_to_do = waiting_.empty() && !injecting_ && velocity_um_per_s_.isZero(0.0) &&
                               (target_um_ == motor_um_ || speed_limit_um_per_s_ == 0.0);
    const double step_s = nothing_to_do ? end_s - time_s_ : std::min(kLongestStep_s, end_s - time_s_);
    if (!nothing_to_do) step(step_s);
    // The last step lands on the end exactly, whatever the rounding of the sum.
    time_s_ = step_s < end_s - time_s_ ? time_s_ + step_s : end_s;
    take_due_commands();
  }
  pose_.time_s = time_s_;
  if (follower_) follower_(pose_);
}

void SimulatedInjector::step(double dt_s) {
  const double a = options_.max_acceleration_um_per_s2;
  // The speed wanted now: what still stops at the target, what the limit allows, what doesn't run past within the step.
  const Eigen::Vector3d way_um = target_um_ - motor_um_;
  Eigen::Vector3d wanted_um_per_s;
  for (int axis = 0; axis < 3; ++axis) {
    const double far_um = std::abs(way_um[axis]);
    wanted_um_per_s[axis] = std::copysign(std::min(braking_speed(far_um, a, dt_s), far_um / dt_s), way_um[axis]);
  }
  const double speed = wanted_um_per_s.norm();
  if (speed > speed_limit_um_per_s_) wanted_um_per_s *= speed_limit_um_per_s_ / speed;
  velocity_um_per_s_ += (wanted_um_per_s - velocity_um_per_s_).cwiseMax(-a * dt_s).cwiseMin(a * dt_s);

  // Motion ends at the travel limits.
  const Eigen::Vector3d moved_um = motor_um_ + velocity_um_per_s_ * dt_s;
  motor_um_ = moved_um.cwiseMax(options_.lower_um.eigen()).cwiseMin(options_.upper_um.eigen());
  for (int axis = 0; axis < 3; ++axis) {
    if (motor_um_[axis] != moved_um[axis]) velocity_um_per_s_[axis] = 0.0;
    if (std::abs(motor_um_[axis] - target_um_[axis]) < 1e-9 && std::abs(velocity_um_per_s_[axis]) <= a * dt_s) {
      motor_um_[axis] = target_um_[axis];
      velocity_um_per_s_[axis] = 0.0;
    }
  }
  // The tip is dragged along once the play is used up.
  const Eigen::Vector3d play_um = Eigen::Vector3d::Constant(options_.backlash_um / 2.0);
  const Eigen::Vector3d tip_um = pose_.tip_um.eigen();
  pose_.tip_um = Eigen::Vector3d(tip_um.cwiseMax(motor_um_ - play_um).cwiseMin(motor_um_ + play_um));
  if (injecting_) pose_.deposited_pl += options_.deposit_rate_pl_per_s * dt_s;
}

PipetteState SimulatedInjector::state(double now_s) {
  if (!open_) throw DeviceError("simulated injector: not open; open it before asking where it is");
  follow_time(now_s);
  PipetteState state;
  state.time_s = time_s_;
  state.known = true;
  state.tip_um = rounded(motor_um_, options_.resolution_um);
  state.velocity_um_per_s = velocity_um_per_s_;
  state.moving = !velocity_um_per_s_.isZero(0.0);
  state.at_limit = target_clamped_;
  state.stopped = stopped_;
  state.expelled_pL = pose_.deposited_pl;
  return state;
}

}  // namespace pellucida
