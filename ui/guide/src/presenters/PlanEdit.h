#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "pellucida/core/Expected.h"
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/visualization/PlanMarks.h"

namespace pellucida {

/// What a person chooses of a plan.
struct PlanChoice {
  Eigen::Vector2d target_um = Eigen::Vector2d::Zero();  ///< frame W, image plane
  double depth_stop_um = 0.0;                           ///< beyond the entry

  bool operator==(const PlanChoice&) const = default;
};
PlanChoice choice_of(const InjectionPlan& plan, double depth_stop_um);

/// The handle nearest to a place, within `reach_um` of it.
PlanHandle handle_at(const PlanMarks& marks, const Eigen::Vector2d& place_um, double reach_um);

/// What a handle drawn to a place makes of a choice. The target goes there; the entry takes the planned line with it,
/// parallel to itself, since a needle enters along its own axis; the depth stop stays on the line, at least 1 um and at
/// most 200 um beyond the entry.
PlanChoice drag_handle(const InjectionPlan& plan, const PlanChoice& from, PlanHandle handle,
                       const Eigen::Vector2d& place_um);

/// The plan with that choice's target, or why there is none.
expected<InjectionPlan, PlanFault> plan_with(const InjectionPlan& plan, const PlanChoice& choice);

/// "Depth stop 46 µm beyond the entry": what is being dragged. UTF-8.
std::string handle_words(const InjectionPlan& plan, const PlanChoice& choice, PlanHandle handle);

/// The plan as it is drawn over the feed.
PlanMarks plan_marks(const InjectionPlan& plan, double depth_stop_um, bool guided);

}  // namespace pellucida
