#include "pellucida/simulation/OperatorPlan.h"

namespace pellucida {

OperatorPlan operator_plan(const InjectionPlan& plan, double scale_um_per_m, double lag_s) {
  constexpr double kRemoval_um = 40.0;
  OperatorPlan way;
  way.approach_um = plan.approach_um;
  way.entry_um = plan.entry_um;
  way.target_um = plan.target_um;
  way.removal_um = Eigen::Vector3d(plan.entry_um.eigen() - kRemoval_um * plan.axis.eigen());
  way.scale_um_per_m = scale_um_per_m;
  way.lag_s = lag_s;
  return way;
}

}  // namespace pellucida
