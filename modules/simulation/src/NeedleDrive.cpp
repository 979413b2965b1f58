#include "pellucida/simulation/NeedleDrive.h"

#include <algorithm>

namespace pellucida {

ScriptedNeedle::ScriptedNeedle(const Scenario& scenario, const VirtualSpecimen& specimen)
    : script_(scenario.motion),
      force_(specimen.force()),
      offset_um_(specimen.offset_um()),
      out_of_plane_um_(scenario.motion.out_of_plane_um),
      out_of_plane_time_s_(scenario.motion.out_of_plane_time_s) {}

NeedleCommand ScriptedNeedle::at(double time_s) {
  constexpr double kHalfStep_s = 0.5e-3;
  NeedleCommand command;
  command.straight_depth_um = script_.depth_um(time_s);
  command.tip_um = force_.tip_at(offset_um_, *command.straight_depth_um);
  const double speed_um_per_s =
      (script_.depth_um(time_s + kHalfStep_s) - script_.depth_um(time_s - kHalfStep_s)) / (2 * kHalfStep_s);
  command.velocity_um_per_s = Eigen::Vector3d(-speed_um_per_s * force_.frame().axis.eigen());
  if (out_of_plane_um_ != 0 && time_s > out_of_plane_time_s_) {
    // No straight push any more.
    constexpr double kTaken_s = 0.3;
    const double part = std::min(1.0, (time_s - out_of_plane_time_s_) / kTaken_s);
    command.straight_depth_um.reset();
    command.tip_um.z += out_of_plane_um_ * part * part * (3 - 2 * part);
  }
  return command;
}

}  // namespace pellucida
