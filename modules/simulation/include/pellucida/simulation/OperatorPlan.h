#pragma once
#include "pellucida/core/PlainVector.h"
#include "pellucida/planning/InjectionPlan.h"

namespace pellucida {

/// The operator's goals, as positions. Frame W, um.
struct OperatorPlan {
  PlainVector3 approach_um;     ///< before the cell, on the line of entry: reached fast, and exactly
  PlainVector3 entry_um;        ///< where the line meets the membrane
  PlainVector3 target_um;       ///< where to deposit
  PlainVector3 removal_um;      ///< where the tip should be in the end
  double inject_s = 1.0;        ///< how long the deposit button is held
  double scale_um_per_m = 1e4;  ///< tip motion for hand motion, as the operator has learnt it: position control
  double insertion_speed_um_per_s = 40.0;  ///< from the approach point to the target
  double deepest_push_um = 75.0;           ///< past the entry point: beyond it the membrane is taken as broken
  /// 0..0.5: how far the tip in a picture lags the hand (filter, manipulator, camera), as the operator has learnt it:
  /// commands given within it are still under way, and are not repeated. Miall and others, J. Motor Behav. 25 (1993).
  double lag_s = 0.0;
};

/// An injection plan as goals of an operator, with what the operator has learnt of the path from hand to image: tip
/// motion per metre of hand motion, and `lag_s` of filter, manipulator and camera. In the end the tip should be 40 um
/// before the membrane, on the line of entry.
OperatorPlan operator_plan(const InjectionPlan& plan, double scale_um_per_m, double lag_s = 0.0);

}  // namespace pellucida
