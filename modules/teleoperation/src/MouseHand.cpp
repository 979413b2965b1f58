#include "pellucida/teleoperation/MouseHand.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kLongestReadGap_s = 0.1;  // a key held while there was no read does not make the hand jump

double unit_clamped(double value) noexcept {
  return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0;
}

}  // namespace

MouseHand::MouseHand(const MouseHandOptions& options) : options_(options) {
  for (const double value : {options.m_per_px, options.m_per_notch, options.steer_m_per_s, options.workspace_radius_m,
                             options.half_ratio_N_per_m}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw UsageError("mouse: every option must be above 0, not " + std::to_string(value));
  }
  specification_.name = "mouse and keyboard";
  specification_.workspace_radius_m = options.workspace_radius_m;
  specification_.resolution_m = options.m_per_px;
  specification_.source = "chosen";
  publish();
}

void MouseHand::move_px(double dx, double dy) noexcept {
  if (!std::isfinite(dx) || !std::isfinite(dy)) return;
  input_.x_px += dx;
  input_.y_px += dy;
  publish();
}

void MouseHand::turn_wheel(double notches) noexcept {
  if (!std::isfinite(notches)) return;
  input_.wheel += notches;
  publish();
}

void MouseHand::steer(const PlainVector3& direction) noexcept {
  input_.steer = {unit_clamped(direction.x), unit_clamped(direction.y), unit_clamped(direction.z)};
  publish();
}

void MouseHand::press(HandButton button) noexcept {
  input_.buttons |= button;
  publish();
}

void MouseHand::release(HandButton button) noexcept {
  input_.buttons &= ~static_cast<std::uint32_t>(button);
  publish();
}

void MouseHand::release_all() noexcept {
  input_.buttons = 0;
  input_.steer = {};
  publish();
}

void MouseHand::set_connected(bool connected) noexcept {
  input_.connected = connected;
  input_.buttons = 0;
  input_.steer = {};
  publish();
}

bool MouseHand::read(double now_s, HandSample& sample) noexcept {
  inputs_.refresh();
  cues_.refresh();
  const Input& input = inputs_.value();
  const double dt_s = last_read_s_ < 0.0 ? 0.0 : std::clamp(now_s - last_read_s_, 0.0, kLongestReadGap_s);
  last_read_s_ = now_s;

  // What the mouse and the keys did since the last reading, frame H.
  Eigen::Vector3d moved_m = input.steer.eigen() * (options_.steer_m_per_s * dt_s);
  moved_m.x() += (input.x_px - seen_.x_px) * options_.m_per_px;
  moved_m.y() -= (input.y_px - seen_.y_px) * options_.m_per_px;
  moved_m.z() -= (input.wheel - seen_.wheel) * options_.m_per_notch;
  seen_ = input;

  // In contact less of it is seen along the force; across it, all.
  const TouchCue& cue = cues_.value();
  const Eigen::Vector3d force_N = cue.force_N.eigen();
  const double size_N = force_N.norm();
  ratio_ = 1.0;
  if (cue.contact && size_N > 0.0) {
    ratio_ = 1.0 / (1.0 + std::max(cue.stiffness_N_per_m, 0.0) / options_.half_ratio_N_per_m);
    const Eigen::Vector3d along = force_N / size_N;
    moved_m -= (1.0 - ratio_) * along.dot(moved_m) * along;
  }
  Eigen::Vector3d goal_m = goal_m_.eigen() + moved_m;
  const double distance_m = goal_m.norm();
  if (distance_m > options_.workspace_radius_m) goal_m *= options_.workspace_radius_m / distance_m;
  goal_m_ = goal_m;
  smoother_.update(goal_m, dt_s);

  sample.time_s = now_s;
  sample.position_m = smoother_.position_m();
  sample.velocity_m_per_s = smoother_.velocity_m_per_s();
  sample.velocity_known = true;
  sample.buttons = input.buttons;
  return input.connected;
}

bool MouseHand::write(const PlainVector3&) noexcept {
  return inputs_.value().connected;
}

void MouseHand::show(const TouchCue& cue) noexcept {
  if (cue.force_N.eigen().allFinite() && std::isfinite(cue.stiffness_N_per_m)) cues_.publish(cue);
}

}  // namespace pellucida
