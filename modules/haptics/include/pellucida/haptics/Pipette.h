#pragma once
#include <cstdint>
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// The command to the injection pipette in one tick. Frame W, um. Trivially copyable.
struct PipetteCommand {
  double time_s = 0.0;  ///< on the run's clock
  PlainVector3 tip_um;  ///< where the tip should be
  PlainVector3 velocity_um_per_s;
  double max_speed_um_per_s = 0.0;  ///< speed limit; 0: stop
  bool inject = false;              ///< deposit
  bool stop = false;                ///< emergency stop: halt at once and stay until released
};
static_assert(std::is_trivially_copyable_v<PipetteCommand>);

/// Where the pipette is, as its manipulator reports. Frame W, um. Trivially copyable.
struct PipetteState {
  double time_s = 0.0;  ///< of the report, on the run's clock
  bool known = false;   ///< false until the manipulator reported, and after it was lost
  PlainVector3 tip_um;
  PlainVector3 velocity_um_per_s;
  bool moving = false;
  bool at_limit = false;     ///< a travel limit was reached
  bool stopped = false;      ///< the emergency stop is in force
  double expelled_pL = 0.0;  ///< by the injector since it was opened; 0 where the manipulator does not inject
};
static_assert(std::is_trivially_copyable_v<PipetteState>);

}  // namespace pellucida
