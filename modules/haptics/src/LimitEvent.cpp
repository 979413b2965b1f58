#include "pellucida/haptics/LimitEvent.h"

namespace pellucida {

std::string_view to_string(LimitKind kind) noexcept {
  switch (kind) {
    case LimitKind::kDepth:
      return "depth";
    case LimitKind::kForce:
      return "force";
    case LimitKind::kSpeed:
      return "speed";
    case LimitKind::kTravel:
      return "travel";
    case LimitKind::kFollowing:
      return "following";
    case LimitKind::kHandForce:
      return "hand force";
    case LimitKind::kHandStiffness:
      return "hand stiffness";
    case LimitKind::kHandSlope:
      return "hand slope";
    case LimitKind::kPassivity:
      return "passivity";
    case LimitKind::kPuncture:
      return "puncture";
    case LimitKind::kBlind:
      return "blind";
    case LimitKind::kContactStale:
      return "contact stale";
    case LimitKind::kContactInvalid:
      return "contact invalid";
    case LimitKind::kHandJump:
      return "hand jump";
    case LimitKind::kHandInvalid:
      return "hand invalid";
    case LimitKind::kHandLost:
      return "hand lost";
    case LimitKind::kPipetteJump:
      return "pipette jump";
    case LimitKind::kPipetteLost:
      return "pipette lost";
    case LimitKind::kLateTick:
      return "late tick";
    case LimitKind::kForceNotFinite:
      return "force not finite";
    case LimitKind::kEmergencyStop:
      return "emergency stop";
    case LimitKind::kCount:
      break;
  }
  return "unknown";
}

}  // namespace pellucida
