#pragma once
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace pellucida {

/// A limit that acts between hand and pipette.
enum class LimitKind : std::uint8_t {
  kDepth,           ///< the tip would go deeper than allowed: slowed, held, drawn back
  kForce,           ///< the force on the cell came near its limit
  kSpeed,           ///< the hand moves faster than the pipette may
  kTravel,          ///< the edge of the box the tip may be in
  kFollowing,       ///< the manipulator lags behind its commands
  kHandForce,       ///< the device's largest force
  kHandStiffness,   ///< the contact would be stiffer than the device can render: the force is scaled down
  kHandSlope,       ///< the force on the hand changed as fast as it may
  kPassivity,       ///< energy came out of the device: damping was added
  kPuncture,        ///< the membrane gave way: the hand's force is released
  kContactStale,    ///< the newest frame is too old: the force is damped to zero
  kContactInvalid,  ///< the newest frame has no usable numbers: the force is damped to zero
  kHandJump,        ///< a reading no hand can make: the motion is re-anchored
  kHandInvalid,     ///< a reading of the hand that is not finite
  kHandLost,        ///< no readings from the device: pipette held, force released
  kPipetteJump,     ///< a report no manipulator can make
  kPipetteLost,     ///< no reports from the manipulator: pipette held, force released
  kLateTick,        ///< a tick so late that the motion is re-anchored
  kForceNotFinite,  ///< the computed force was not finite: zero was written
  kEmergencyStop,   ///< everything is stopped until released
  kBlind,           ///< the hand would push on while the contact is unknown: pipette held
  kCount
};

/// "depth", "force", "speed", ...: as written to `events.csv`.
std::string_view to_string(LimitKind kind) noexcept;

/// A limit that began or ceased to act. Trivially copyable: it goes through `SpscRing`.
struct LimitEvent {
  double time_s = 0.0;  ///< on the run's clock
  LimitKind kind = LimitKind::kDepth;
  bool begun = false;  ///< false: it ceased to act
  double value = 0.0;  ///< what was measured, in the unit of the limit (um, uN, N, um/s, s); 0 where there is none
  double limit = 0.0;
};
static_assert(std::is_trivially_copyable_v<LimitEvent>);

/// Bit of a kind in a mask of the limits that act now.
constexpr std::uint32_t limit_bit(LimitKind kind) noexcept {
  return std::uint32_t{1} << static_cast<unsigned>(kind);
}

}  // namespace pellucida
