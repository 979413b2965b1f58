#include "pellucida/simulation/NeedleDrive.h"

namespace pellucida {

ScriptedNeedle::ScriptedNeedle(const Scenario& scenario, const VirtualSpecimen& specimen)
    : script_(scenario.motion), force_(specimen.force()), offset_um_(specimen.offset_um()) {}

NeedleCommand ScriptedNeedle::at(double time_s) {
  constexpr double kHalfStep_s = 0.5e-3;
  NeedleCommand command;
  command.straight_depth_um = script_.depth_um(time_s);
  command.tip_um = force_.tip_at(offset_um_, *command.straight_depth_um);
  const double speed_um_per_s =
      (script_.depth_um(time_s + kHalfStep_s) - script_.depth_um(time_s - kHalfStep_s)) / (2 * kHalfStep_s);
  command.velocity_um_per_s = Eigen::Vector3d(-speed_um_per_s * force_.frame().axis.eigen());
  return command;
}

}  // namespace pellucida
