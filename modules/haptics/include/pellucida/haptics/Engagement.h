#pragma once
#include <cstdint>

namespace pellucida {

/// How the hand holds the pipette.
///
/// | state        | the pipette                         | leaves it for                                             |
/// |--------------|-------------------------------------|-----------------------------------------------------------|
/// | kWaiting     | is still; no hand has led it yet    | kLeading, when hand and pipette are there                 |
/// | kDisplaced   | held, and may have moved by itself  | kLeading, from where the pipette is then                  |
/// | kReleased    | held where the hand left it         | kLeading, when the hand is there                          |
/// | kLeading     | follows the hand                    | the three below, by what the hand asks                    |
/// | kClutched    | held; the hand moves freely         | kLeading, from where the hand is then                     |
/// | kHolding     | held: the hand asks for more depth than it may have | kLeading, when it comes back or may go on |
/// | kRetracting  | is taken back along the push        | kLeading, when the button is released                     |
///
/// The last four are engaged states: the motion map joins hand and tip, and the device gives its force. A lost, jumped
/// or stopped pipette leads from each state but kWaiting to kDisplaced; a lost hand from the engaged ones to kReleased.
/// The emergency stop is no state but a latch: while it is set the pipette is displaced, or still waits.
enum class Engagement : std::uint8_t { kWaiting, kDisplaced, kReleased, kLeading, kClutched, kHolding, kRetracting };

/// What may change it, in the order in which a tick asks.
enum class EngagementEvent : std::uint8_t {
  kPipetteOut,  ///< the pipette was lost, has jumped, or is stopped
  kHandOut,     ///< no reading that may be followed, or the loop ends
  kReady,       ///< hand and pipette are there
  kLead,        ///< the engaged hand asks for nothing else
  kClutch,      ///< it holds the clutch
  kBar,         ///< it asks for more depth than it may have
  kRetract      ///< it asks for the pipette to be taken back
};

constexpr bool is_engaged(Engagement state) noexcept {
  return state >= Engagement::kLeading;
}

/// The one transition function. What the hand asks (from kLead on) counts in engaged states only.
constexpr Engagement next(Engagement state, EngagementEvent event) noexcept {
  if (event == EngagementEvent::kPipetteOut) {
    return state == Engagement::kWaiting ? Engagement::kWaiting : Engagement::kDisplaced;
  }
  if (event == EngagementEvent::kReady) return is_engaged(state) ? state : Engagement::kLeading;
  if (!is_engaged(state)) return state;
  switch (event) {
    case EngagementEvent::kHandOut:
      return Engagement::kReleased;
    case EngagementEvent::kClutch:
      return Engagement::kClutched;
    case EngagementEvent::kBar:
      return Engagement::kHolding;
    case EngagementEvent::kRetract:
      return Engagement::kRetracting;
    default:
      return Engagement::kLeading;
  }
}

}  // namespace pellucida
