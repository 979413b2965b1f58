#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include "pellucida/core/Words.h"

namespace pellucida {

/// Something that happened in a session: a row of `events.csv` (`time_s,kind,detail`).
struct Event {
  double time_s = 0.0;
  std::string kind;  ///< one of `kEventKinds`; a later version's session may hold others
  std::string detail;
};

/// The names of the kinds of event (a contract).
namespace event_kind {
inline constexpr const char* kContact = PELLUCIDA_WORDS("contact");
inline constexpr const char* kRelease = PELLUCIDA_WORDS("release");
inline constexpr const char* kPuncture = PELLUCIDA_WORDS("puncture");
inline constexpr const char* kRevoked = PELLUCIDA_WORDS("revoked");
inline constexpr const char* kLost = PELLUCIDA_WORDS("lost");
inline constexpr const char* kFound = PELLUCIDA_WORDS("found");
inline constexpr const char* kWarning = PELLUCIDA_WORDS("warning");
inline constexpr const char* kPalpation = PELLUCIDA_WORDS("palpation");
inline constexpr const char* kLimit = PELLUCIDA_WORDS("limit");
inline constexpr const char* kNote = PELLUCIDA_WORDS("note");
inline constexpr const char* kHint = PELLUCIDA_WORDS("hint");
inline constexpr const char* kUnmeasured = PELLUCIDA_WORDS("unmeasured");
inline constexpr const char* kDropped = PELLUCIDA_WORDS("dropped");
inline constexpr const char* kThinned = PELLUCIDA_WORDS("thinned");
inline constexpr const char* kGap = PELLUCIDA_WORDS("gap");
inline constexpr const char* kDamaged = PELLUCIDA_WORDS("damaged");
inline constexpr const char* kPaused = PELLUCIDA_WORDS("paused");
inline constexpr const char* kResumed = PELLUCIDA_WORDS("resumed");
inline constexpr const char* kStarted = PELLUCIDA_WORDS("started");
inline constexpr const char* kStopped = PELLUCIDA_WORDS("stopped");
}  // namespace event_kind

/// How a note begins that is the measurement's own, not a person's: why there is no force.
inline constexpr std::string_view kNoForceNote = "no force: ";

struct EventKindInfo {
  std::string_view name;
  std::string_view meaning;  ///< as in docs/file-format.md
};

/// Every kind of event there is. docs/file-format.md lists the same.
inline constexpr std::array kEventKinds{
    EventKindInfo{event_kind::kContact, "the needle touches the cell"},
    EventKindInfo{event_kind::kRelease, "the needle has left the cell"},
    EventKindInfo{event_kind::kPuncture,
                  "the membrane gave way; detail: the largest force before, the depth at it, the work of the needle on "
                  "the cell in uN um (1e-12 J)"},
    EventKindInfo{
        event_kind::kRevoked,
        "the puncture reported last was none, the contact goes on; detail: where membrane and tip are together "
        "again"},
    EventKindInfo{event_kind::kLost, "the cell, or its surface, can't be seen any more; detail: the reason"},
    EventKindInfo{event_kind::kFound, "the cell is seen, for the first time or again"},
    EventKindInfo{event_kind::kWarning,
                  "the force is less certain from this frame on; detail: `mismatch`, `slip`, `asymmetry` or "
                  "`profile`, and by how much"},
    EventKindInfo{event_kind::kPalpation, "this cell's own stiffness has been taken into account; detail: the factor"},
    EventKindInfo{event_kind::kLimit,
                  "a safety limit of the hand acts; detail: which, the value and the limit. `over`: it has ceased to "
                  "act; detail: for how long and how often it did"},
    EventKindInfo{event_kind::kNote, "the operator's words, or a remark by the measurement"},
    EventKindInfo{event_kind::kHint,
                  "a person pointed at something in the image, and the tracking followed from this frame on; detail: "
                  "`cell at X Y um`, `needle tip at X Y um`, `no cell at X Y um`, `holding pipette at X Y um`, `cell "
                  "outlined by N places: X Y X Y ... um` or `taken back`, and what came of it"},
    EventKindInfo{event_kind::kUnmeasured,
                  "frames were recorded with their image but not measured: their rows have an empty state; detail: how "
                  "many, and the first and last"},
    EventKindInfo{
        event_kind::kDropped,
        "the recorder kept frames without their image; detail: how many, the first and last, and what was too "
        "slow"},
    EventKindInfo{event_kind::kThinned,
                  "the recorder kept frames without their surface, all else whole; detail: as for `dropped`"},
    EventKindInfo{event_kind::kGap, "the source itself lost frames; detail: how many, and where"},
    EventKindInfo{
        event_kind::kDamaged,
        "frames of the source could not be decoded as they were recorded: they are kept, not measured; detail: "
        "the first, and the decoder's words. `over`: the frames are whole again; detail: how many were not"},
    EventKindInfo{event_kind::kPaused, "the operator paused the source"},
    EventKindInfo{event_kind::kResumed,
                  "the pause is over; detail: how many frames of a live source were not taken meanwhile"},
    EventKindInfo{event_kind::kStarted, "the recording began"},
    EventKindInfo{event_kind::kStopped, "the recording ended"},
};

/// Whether the `puncture` at place `index` of a session's events (any range of what has a `kind`, in the order of time)
/// was revoked before the next one.
template <class Events>
bool is_revoked(const Events& events, std::size_t index) {
  const auto next = std::find_if(
      std::begin(events) + static_cast<std::ptrdiff_t>(index) + 1, std::end(events),
      [](const auto& event) { return event.kind == event_kind::kPuncture || event.kind == event_kind::kRevoked; });
  return next != std::end(events) && next->kind == event_kind::kRevoked;
}

}  // namespace pellucida
