#include "pellucida/planning/InjectionPlan.h"

#include <cmath>

#include "pellucida/haptics/ForceGuards.h"

namespace pellucida {
namespace {

bool is_unit(const PlainVector3& v) noexcept {
  return std::abs(v.eigen().norm() - 1.0) < 1e-3;
}

bool sound(const CellGeometry& cell, const PlanOptions& options) noexcept {
  for (const double value :
       {cell.outer_radius_um, options.approach_distance_um, options.holder_radius_um, options.approach_speed_um_per_s,
        options.insertion_speed_um_per_s, options.removal_speed_um_per_s}) {
    if (!(std::isfinite(value) && value > 0.0)) return false;
  }
  for (const double value : {cell.inner_radius_um, options.overshoot_um, options.path_radius_um}) {
    if (!(std::isfinite(value) && value >= 0.0)) return false;
  }
  return is_finite(cell.center_um.eigen()) && cell.inner_radius_um <= cell.outer_radius_um &&
         std::isfinite(options.needle_clearance_um) && options.needle_clearance_um > options.path_radius_um &&
         options.cone_half_angle_rad >= 0.0 && options.cone_half_angle_rad <= 1.4 &&
         (!cell.holder_known || (is_finite(cell.holder_mouth_um.eigen()) && is_unit(cell.holder_direction)));
}

bool in_holder(const CellGeometry& cell, const PlanOptions& options, const Eigen::Vector3d& place_um) noexcept {
  if (!cell.holder_known) return false;
  const Eigen::Vector3d direction = cell.holder_direction.eigen();
  const Eigen::Vector3d from_mouth = place_um - cell.holder_mouth_um.eigen();
  const double along_um = from_mouth.dot(direction);
  return along_um > 0.0 && (from_mouth - along_um * direction).norm() < options.holder_radius_um;
}

}  // namespace

std::optional<CellGeometry> geometry_of(const ContactModel& model) noexcept {
  if (!model.cell_seen) return std::nullopt;
  CellGeometry cell;
  cell.center_um = model.center_um;
  cell.outer_radius_um = model.outer_radius_um;
  cell.inner_radius_um = model.inner_radius_um;
  cell.needle_direction = model.push;
  cell.holder_known = model.holder_seen;
  cell.holder_mouth_um = model.holder_mouth_um;
  cell.holder_direction = model.holder_direction;
  return cell;
}

std::string to_string(PlanFault fault) {
  switch (fault) {
    case PlanFault::kNotFinite:
      return "a number of the plan isn't finite or out of range; correct the cell's geometry or the plan's options";
    case PlanFault::kNoDirection:
      return "the needle's direction is unknown; bring the needle into the image first";
    case PlanFault::kTargetOutside:
      return "the target lies outside the cell; choose one within the inner membrane";
    case PlanFault::kOvershootTooFar:
      return "target and overshoot together reach the far side of the cell; choose a target nearer, or less overshoot";
    case PlanFault::kThroughHolder:
      return "the path leads through the holding pipette; turn the cell, or move the needle to another side";
  }
  return "no plan";
}

expected<InjectionPlan, PlanFault> plan_injection(const CellGeometry& cell,
                                                  const std::optional<PlainVector3>& target_um,
                                                  const PlanOptions& options) noexcept {
  InjectionPlan plan;
  plan.cell = cell;
  plan.options = options;
  plan.target_um = target_um.value_or(cell.center_um);
  if (!sound(cell, options) || !is_finite(plan.target_um.eigen())) return unexpected<PlanFault>(PlanFault::kNotFinite);
  if (!is_finite(cell.needle_direction.eigen()) || !is_unit(cell.needle_direction)) {
    return unexpected<PlanFault>(PlanFault::kNoDirection);
  }
  const Eigen::Vector3d axis = cell.needle_direction.eigen().normalized();
  const Eigen::Vector3d from_center = plan.target_um.eigen() - cell.center_um.eigen();
  const double reach_um = cell.inner_radius_um > 0.0 ? cell.inner_radius_um : cell.outer_radius_um;
  if (from_center.norm() >= reach_um) return unexpected<PlanFault>(PlanFault::kTargetOutside);

  // The line target + t axis meets the sphere at t = -b -+ sqrt(b^2 - c); the target is inside, so c < 0.
  const double b = from_center.dot(axis);
  const double c = from_center.squaredNorm() - cell.outer_radius_um * cell.outer_radius_um;
  const double root = std::sqrt(b * b - c);
  plan.depth_um = b + root;
  const double to_far_side_um = root - b;
  if (options.overshoot_um >= to_far_side_um) return unexpected<PlanFault>(PlanFault::kOvershootTooFar);
  plan.axis = axis;
  const Eigen::Vector3d entry_um = plan.target_um.eigen() - plan.depth_um * axis;
  const Eigen::Vector3d approach_um = entry_um - options.approach_distance_um * axis;
  plan.entry_um = entry_um;
  plan.approach_um = approach_um;
  if (in_holder(cell, options, entry_um) || in_holder(cell, options, approach_um)) {
    return unexpected<PlanFault>(PlanFault::kThroughHolder);
  }
  return plan;
}

HapticSettings with_plan(HapticSettings settings, const InjectionPlan& plan) noexcept {
  FixtureSet& set = settings.fixtures;
  const PlanOptions& options = plan.options;
  set.guide.enabled = set.cone.enabled = set.stop.enabled = set.cell.enabled = true;
  set.guide.entry_um = set.cone.entry_um = set.stop.entry_um = set.cell.entry_um = plan.entry_um;
  set.guide.axis = set.cone.axis = set.stop.axis = set.cell.axis = plan.axis;
  set.guide.radius_um = set.cone.radius_um = options.path_radius_um;
  set.cone.half_angle_rad = options.cone_half_angle_rad;
  set.cone.length_um = options.approach_distance_um;
  set.stop.depth_um = plan.depth_um + options.overshoot_um;
  set.cell.center_um = plan.cell.center_um;
  set.cell.radius_um = plan.cell.outer_radius_um;
  set.cell.path_radius_um = options.needle_clearance_um;
  set.holder.enabled = plan.cell.holder_known;
  if (plan.cell.holder_known) {
    set.holder.mouth_um = plan.cell.holder_mouth_um;
    set.holder.direction = plan.cell.holder_direction;
    set.holder.radius_um = options.holder_radius_um;
  }
  settings.limits.max_speed_um_per_s = options.approach_speed_um_per_s;
  settings.limits.max_contact_speed_um_per_s = options.insertion_speed_um_per_s;
  settings.limits.retract_speed_um_per_s = options.removal_speed_um_per_s;
  return settings;
}

}  // namespace pellucida
