#include "InjectionGuide.h"

#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kFreeFrames = 3;           // in a row, before a plan is made
constexpr double kSureConfidence = 0.6;  // of each of them

bool needle_seen(const ContactModel& contact) noexcept {
  return contact.push.eigen().squaredNorm() > 0.25;
}

}  // namespace

bool InjectionGuide::see(const ContactModel& contact) noexcept {
  const bool untouched = contact.state == CellState::kFree && contact.cell_seen && needle_seen(contact) &&
                         contact.confidence >= kSureConfidence;
  free_count_ = untouched ? free_count_ + 1 : 0;
  return free_count_ >= kFreeFrames;
}

std::optional<std::string> InjectionGuide::make(const ContactModel& contact) {
  const auto cell = geometry_of(contact);
  if (!cell) return "No plan: the cell isn't seen";
  std::optional<PlainVector3> target_um;
  if (target_offset_um_) target_um = Eigen::Vector3d(cell->center_um.eigen() + target_offset_um_->eigen());
  const auto plan = plan_injection(*cell, target_um);
  if (!plan) return "No plan: " + to_string(plan.error());
  plan_ = *plan;
  return std::nullopt;
}

void InjectionGuide::drop() noexcept {
  plan_.reset();
  free_count_ = 0;
}

std::optional<std::string> InjectionGuide::set_target(double x_um, double y_um) {
  if (!plan_) return "no cell has been seen yet; the target can be set once there is a plan";
  const PlainVector3 target_um{x_um, y_um, plan_->cell.center_um.z};
  const auto trial = plan_injection(plan_->cell, target_um, plan_->options);
  if (!trial) return to_string(trial.error());
  target_offset_um_ = Eigen::Vector3d(target_um.eigen() - plan_->cell.center_um.eigen());
  return std::nullopt;
}

void InjectionGuide::depth_stop_um(double depth_um) {
  if (!(depth_um > 0.0) || !std::isfinite(depth_um)) {
    throw UsageError("depth stop: " + std::to_string(depth_um) + " um must be above 0");
  }
  depth_stop_um_ = depth_um;
}

double InjectionGuide::depth_stop_um() const noexcept {
  if (depth_stop_um_) return *depth_stop_um_;
  return plan_ ? plan_->depth_um + plan_->options.overshoot_um : 0.0;
}

HapticSettings InjectionGuide::apply(const HapticSettings& settings) const noexcept {
  if (!plan_) return settings;
  HapticSettings guided = with_plan(settings, *plan_);
  guided.fixtures.stop.depth_um = depth_stop_um();
  if (!guided_) guided.fixtures.guide.enabled = guided.fixtures.cone.enabled = guided.fixtures.cell.enabled = false;
  return guided;
}

}  // namespace pellucida
