#pragma once
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/OperatorModel.h"

namespace pellucida {

/// An injection plan as an operator is told it, with what the operator has learnt of the way from hand to picture: tip
/// motion for a metre of hand motion, and `lag_s` of filter, manipulator and camera. In the end the tip shall be 40 um
/// before the membrane, on the line it went in.
OperatorPlan operator_plan(const InjectionPlan& plan, double scale_um_per_m, double lag_s = 0.0);

}  // namespace pellucida
