#pragma once
#include "pellucida/planning/InjectionPlan.h"
#include "pellucida/simulation/OperatorModel.h"

namespace pellucida {

/// An injection plan as goals of an operator, with what the operator has learnt of the path from hand to image: tip
/// motion per metre of hand motion, and `lag_s` of filter, manipulator and camera. In the end the tip should be 40 um
/// before the membrane, on the line of entry.
OperatorPlan operator_plan(const InjectionPlan& plan, double scale_um_per_m, double lag_s = 0.0);

}  // namespace pellucida
