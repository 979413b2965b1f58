#include "pellucida/haptics/CellGuards.h"

#include <algorithm>
#include <cmath>

#include "pellucida/haptics/ForceGuards.h"

namespace pellucida {
namespace {

constexpr double kStill_um = 1e-9;
constexpr double kReportSlack_um = 5.0;

// 1 up to `from`, 0 at `to` and beyond.
double falling(double value, double from, double to) noexcept {
  if (value <= from) return 1.0;
  if (value >= to) return 0.0;
  return (to - value) / (to - from);
}

}  // namespace

CellLimits limits_of(const CellStrength& cell) noexcept {
  CellLimits limits;
  limits.max_force_uN = kPunctureMargin * cell.puncture_force_uN;
  limits.max_depth_um = kPunctureMargin * cell.puncture_depth_um;
  return limits;
}

void CellGuards::place(const Eigen::Vector3d& tip_um) noexcept {
  tip_um_ = tip_um;
  retracting_ = false;
}

double CellGuards::push_part(const GuardInput& input, std::uint32_t& acting) noexcept {
  if (!input.in_contact) {
    retracting_ = false;
    return 1.0;
  }
  const double depth_part = falling(input.depth_um, limits_.max_depth_um - limits_.soft_depth_um, limits_.max_depth_um);
  const double force_part =
      falling(input.contact_force_uN, limits_.slow_ratio * limits_.max_force_uN, limits_.max_force_uN);
  if (depth_part < 1.0) acting |= limit_bit(LimitKind::kDepth);
  if (force_part < 1.0) acting |= limit_bit(LimitKind::kForce);
  const bool beyond = input.depth_um > limits_.max_depth_um + limits_.soft_depth_um ||
                      input.contact_force_uN > limits_.retract_ratio * limits_.max_force_uN;
  const bool within = input.depth_um <= limits_.max_depth_um && input.contact_force_uN <= limits_.max_force_uN;
  retracting_ = beyond || (retracting_ && !within);
  return std::min(depth_part, force_part);
}

Eigen::Vector3d CellGuards::move(const Eigen::Vector3d& step_um, double dt_s, std::uint32_t& acting) noexcept {
  const double longest_um = limits_.max_speed_um_per_s * dt_s;
  if (step_um.norm() > longest_um * (1.0 + 1e-9)) acting |= limit_bit(LimitKind::kSpeed);
  const Eigen::Vector3d from_um = tip_um_;
  const Eigen::Vector3d to_um = tip_um_ + saturate(step_um, longest_um);
  // A proxy outside the box (the box was made smaller) comes back at the allowed speed, too.
  const Eigen::Vector3d boxed_um = to_um.cwiseMax(limits_.lower_um.eigen()).cwiseMin(limits_.upper_um.eigen());
  if ((boxed_um - to_um).norm() > kStill_um) acting |= limit_bit(LimitKind::kTravel);
  tip_um_ = limit_change(from_um, boxed_um, longest_um);
  return dt_s > 0.0 ? Eigen::Vector3d((tip_um_ - from_um) / dt_s) : Eigen::Vector3d::Zero();
}

GuardOutput CellGuards::follow(const GuardInput& input) noexcept {
  GuardOutput output;
  const double part = push_part(input, output.limits);
  Eigen::Vector3d step_um = input.wanted_um - tip_um_;

  // In contact the way along the push has a speed limit of its own, which falls to nothing towards depth and force
  // limits.
  if (input.in_contact) {
    const double forward_um = step_um.dot(input.push);
    const double most_um = part * limits_.max_contact_speed_um_per_s * input.dt_s;
    if (forward_um > most_um) {
      step_um -= (forward_um - most_um) * input.push;
      if (part >= 1.0) output.limits |= limit_bit(LimitKind::kSpeed);
      if (part < 1.0) output.mode = part > 0.0 ? GuardMode::kSlow : GuardMode::kHold;
    }
    if (retracting_) {
      const double back_um = limits_.retract_speed_um_per_s * input.dt_s;
      const double now_um = step_um.dot(input.push);
      if (now_um > -back_um) step_um -= (now_um + back_um) * input.push;
      output.mode = GuardMode::kRetract;
    }
  }
  // A manipulator that stays behind is waited for.
  const double lag_um = (tip_um_ - input.pipette.tip_um.eigen()).norm();
  const double lag_part = falling(lag_um, limits_.max_lag_um, 2.0 * limits_.max_lag_um);
  if (lag_part < 1.0) {
    output.limits |= limit_bit(LimitKind::kFollowing);
    step_um = saturate(step_um, lag_part * limits_.max_speed_um_per_s * input.dt_s);
    if (output.mode == GuardMode::kFollow) output.mode = lag_part > 0.0 ? GuardMode::kSlow : GuardMode::kHold;
  }
  output.velocity_um_per_s = move(step_um, input.dt_s, output.limits);
  output.tip_um = tip_um_;
  return output;
}

GuardOutput CellGuards::hold() const noexcept {
  GuardOutput output;
  output.tip_um = tip_um_;
  output.mode = GuardMode::kHold;
  return output;
}

GuardOutput CellGuards::retract(const GuardInput& input) noexcept {
  GuardOutput output;
  output.mode = GuardMode::kRetract;
  output.velocity_um_per_s = move(-limits_.retract_speed_um_per_s * input.dt_s * input.push, input.dt_s, output.limits);
  output.tip_um = tip_um_;
  return output;
}

PipetteGuard::Report PipetteGuard::check(const PipetteState& state, double max_speed_um_per_s) noexcept {
  if (!state.known || !is_finite(state.tip_um.eigen())) {
    last_ = PipetteState{};
    return Report::kUnknown;
  }
  const bool jump =
      last_.known && (state.tip_um.eigen() - last_.tip_um.eigen()).norm() >
                         max_speed_um_per_s * std::max(0.0, state.time_s - last_.time_s) + kReportSlack_um;
  last_ = state;
  return jump ? Report::kJump : Report::kGood;
}

}  // namespace pellucida
