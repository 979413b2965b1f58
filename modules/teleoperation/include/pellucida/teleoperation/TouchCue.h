#pragma once
#include <type_traits>

#include "pellucida/core/PlainVector.h"
#include "pellucida/haptics/HapticRecord.h"

namespace pellucida {

/// The contact as a device without force output can show it: a mouse by moving less, a gamepad by its rumble. Frame H,
/// hand side. Trivially copyable.
struct TouchCue {
  bool contact = false;
  PlainVector3 force_N;            ///< a haptic device would exert on the hand
  double stiffness_N_per_m = 0.0;  ///< of the contact as the hand would feel it, along the force
};
static_assert(std::is_trivially_copyable_v<TouchCue>);

/// Scale of hand force to force at the cell in a cue: the puncture of a mouse oocyte, 7.5 uN, is 1.5 N.
inline constexpr double kCueScale_N_per_uN = 0.2;

/// The cue of a tick: the contact's force at `force_scale_N_per_uN` (a device without force works with a scale of 0, so
/// it is given here), its stiffness the force over the depth. No contact unless the hand is engaged. For readers of the
/// loop's newest record.
TouchCue touch_cue(const HapticRecord& record, double force_scale_N_per_uN = kCueScale_N_per_uN) noexcept;

/// A device that can show a `TouchCue`.
class TouchCueDevice {
 public:
  virtual ~TouchCueDevice() = default;

  /// One thread, the 1 kHz loop's or slower: neither allocates, locks, logs nor throws. Non-finite numbers are ignored.
  virtual void show(const TouchCue& cue) noexcept = 0;
};

}  // namespace pellucida
