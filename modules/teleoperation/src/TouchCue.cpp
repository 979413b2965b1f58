#include "pellucida/teleoperation/TouchCue.h"

#include <algorithm>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {
namespace {

constexpr double kLeastDepth_um = 0.5;  // below it a depth says little, and the secant would run away

}  // namespace

TouchCue touch_cue(const HapticRecord& record, double force_scale_N_per_uN) noexcept {
  TouchCue cue;
  cue.contact = record.contact_state == ContactState::kContact && record.hand_state == HandState::kWorking;
  if (!cue.contact) return cue;
  const Eigen::Vector3d force_uN = record.contact_force_uN.eigen();
  cue.force_N = Eigen::Vector3d(force_scale_N_per_uN * hand_from_world(force_uN).eigen());
  const double secant_uN_per_um = force_uN.norm() / std::max(record.depth_um, kLeastDepth_um);
  cue.stiffness_N_per_m = secant_uN_per_um * force_scale_N_per_uN * record.scale_um_per_m;
  return cue;
}

}  // namespace pellucida
