#include "ScriptedHand.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace pellucida {
namespace {

constexpr double kReach_m = 0.03, kSway_m = 0.003;
constexpr double kPushRate_per_s = 2.0 * std::numbers::pi * 0.4, kSwayRate_per_s = 2.0 * std::numbers::pi * 1.1;

}  // namespace

ScriptedHand::ScriptedHand(DeviceSpecification specification) : specification_(std::move(specification)) {}

bool ScriptedHand::read(double now_s, HandSample& sample) noexcept {
  sample = HandSample{};
  sample.time_s = now_s;
  sample.position_m = {0.5 * kReach_m * (1.0 - std::cos(kPushRate_per_s * now_s)),
                       kSway_m * std::sin(kSwayRate_per_s * now_s), 0.0};
  sample.velocity_m_per_s = {0.5 * kReach_m * kPushRate_per_s * std::sin(kPushRate_per_s * now_s),
                             kSway_m * kSwayRate_per_s * std::cos(kSwayRate_per_s * now_s), 0.0};
  sample.velocity_known = true;
  return true;
}

bool ScriptedHand::write(const PlainVector3&) noexcept {
  return true;
}

void PlainMap::engage(const HandSample& hand, const PlainVector3& tip_um) noexcept {
  const Eigen::Vector3d offset_um = tip_um.eigen() - scale_ * world_from_hand(hand.position_m).eigen();
  offset_um_ = offset_um;
}

TipTarget PlainMap::update(const HandSample& hand, double) noexcept {
  TipTarget target;
  target.tip_um = Eigen::Vector3d(offset_um_.eigen() + scale_ * world_from_hand(hand.position_m).eigen());
  target.velocity_um_per_s = Eigen::Vector3d(scale_ * world_from_hand(hand.velocity_m_per_s).eigen());
  return target;
}

}  // namespace pellucida
