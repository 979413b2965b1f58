#include "pellucida/haptics/LimitEvent.h"

#include "pellucida/core/Words.h"

namespace pellucida {

std::string_view to_string(LimitKind kind) noexcept {
  switch (kind) {
    case LimitKind::kDepth:
      return PELLUCIDA_WORDS("depth");
    case LimitKind::kForce:
      return PELLUCIDA_WORDS("force");
    case LimitKind::kSpeed:
      return PELLUCIDA_WORDS("speed");
    case LimitKind::kTravel:
      return PELLUCIDA_WORDS("travel");
    case LimitKind::kFollowing:
      return PELLUCIDA_WORDS("following");
    case LimitKind::kHandForce:
      return PELLUCIDA_WORDS("hand force");
    case LimitKind::kHandStiffness:
      return PELLUCIDA_WORDS("hand stiffness");
    case LimitKind::kHandSlope:
      return PELLUCIDA_WORDS("hand slope");
    case LimitKind::kPassivity:
      return PELLUCIDA_WORDS("passivity");
    case LimitKind::kPuncture:
      return PELLUCIDA_WORDS("puncture");
    case LimitKind::kBlind:
      return PELLUCIDA_WORDS("blind");
    case LimitKind::kContactStale:
      return PELLUCIDA_WORDS("contact stale");
    case LimitKind::kContactInvalid:
      return PELLUCIDA_WORDS("contact invalid");
    case LimitKind::kHandJump:
      return PELLUCIDA_WORDS("hand jump");
    case LimitKind::kHandInvalid:
      return PELLUCIDA_WORDS("hand invalid");
    case LimitKind::kHandLost:
      return PELLUCIDA_WORDS("hand lost");
    case LimitKind::kPipetteJump:
      return PELLUCIDA_WORDS("pipette jump");
    case LimitKind::kPipetteLost:
      return PELLUCIDA_WORDS("pipette lost");
    case LimitKind::kLateTick:
      return PELLUCIDA_WORDS("late tick");
    case LimitKind::kForceNotFinite:
      return PELLUCIDA_WORDS("force not finite");
    case LimitKind::kEmergencyStop:
      return PELLUCIDA_WORDS("emergency stop");
    case LimitKind::kCount:
      break;
  }
  return PELLUCIDA_WORDS("unknown");
}

}  // namespace pellucida
