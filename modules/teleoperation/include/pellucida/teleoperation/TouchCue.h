#pragma once
#include <type_traits>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// The contact as a device that gives no true force can still tell it: a mouse by moving less, a gamepad by its rumble.
/// Frame H, hand side. Trivially copyable.
struct TouchCue {
  bool contact = false;
  PlainVector3 force_N;            ///< that a haptic device would have put on the hand
  double stiffness_N_per_m = 0.0;  ///< of the contact as the hand would feel it, along the force
};
static_assert(std::is_trivially_copyable_v<TouchCue>);

/// A device that can tell a `TouchCue`.
class TouchCueDevice {
 public:
  virtual ~TouchCueDevice() = default;

  /// One thread, the 1 kHz loop's or slower: neither allocates, locks, logs nor throws. Non-finite numbers are ignored.
  virtual void show(const TouchCue& cue) noexcept = 0;
};

}  // namespace pellucida
