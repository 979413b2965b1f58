#include "presenters/PlanEdit.h"

#include <algorithm>
#include <utility>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr double kShallowestStop_um = 1.0, kDeepestStop_um = 200.0;

Eigen::Vector2d in_plane(const PlainVector3& v) {
  return {v.x, v.y};
}

}  // namespace

PlanChoice choice_of(const InjectionPlan& plan, double depth_stop_um) {
  return {in_plane(plan.target_um), depth_stop_um};
}

PlanHandle handle_at(const PlanMarks& marks, const Eigen::Vector2d& place_um, double reach_um) {
  PlanHandle nearest = PlanHandle::kNone;
  for (const auto& [handle, at_um] :
       {std::pair{PlanHandle::kTarget, marks.target_um}, std::pair{PlanHandle::kDepthStop, marks.depth_stop_um},
        std::pair{PlanHandle::kEntry, marks.entry_um}}) {
    const double away_um = (at_um - place_um).norm();
    if (away_um > reach_um) continue;
    nearest = handle;
    reach_um = away_um;
  }
  return nearest;
}

PlanChoice drag_handle(const InjectionPlan& plan, const PlanChoice& from, PlanHandle handle,
                       const Eigen::Vector2d& place_um) {
  PlanChoice choice = from;
  const Eigen::Vector2d axis = in_plane(plan.axis), way = place_um - in_plane(plan.entry_um);
  switch (handle) {
    case PlanHandle::kTarget:
      choice.target_um = place_um;
      break;
    case PlanHandle::kEntry:
      choice.target_um = in_plane(plan.target_um) + way - way.dot(axis) * axis;
      break;
    case PlanHandle::kDepthStop:
      choice.depth_stop_um = std::clamp(way.dot(axis), kShallowestStop_um, kDeepestStop_um);
      break;
    case PlanHandle::kNone:
      break;
  }
  return choice;
}

expected<InjectionPlan, PlanFault> plan_with(const InjectionPlan& plan, const PlanChoice& choice) {
  return plan_injection(plan.cell, PlainVector3{choice.target_um.x(), choice.target_um.y(), plan.target_um.z},
                        plan.options);
}

std::string handle_words(const InjectionPlan& plan, const PlanChoice& choice, PlanHandle handle) {
  if (handle == PlanHandle::kDepthStop) {
    return say("Depth stop ") + readout::number(choice.depth_stop_um, 0) + say(" µm beyond the entry");
  }
  const auto changed = plan_with(plan, choice);
  if (!changed) return say_message(to_string(changed.error()));
  return say("Target ") + readout::number(changed->depth_um, 0) + say(" µm beyond the entry");
}

PlanMarks plan_marks(const InjectionPlan& plan, double depth_stop_um, bool guided) {
  PlanMarks marks;
  marks.approach_um = in_plane(plan.approach_um);
  marks.entry_um = in_plane(plan.entry_um);
  marks.target_um = in_plane(plan.target_um);
  marks.depth_stop_um = marks.entry_um + depth_stop_um * in_plane(plan.axis);
  marks.corridor_um = plan.options.path_radius_um;
  marks.guided = guided;
  return marks;
}

}  // namespace pellucida
