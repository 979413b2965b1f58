#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"

namespace pellucida {

/// What a person says of the image with the mouse: where something is, or is not. The session keeps it as an event
/// `hint` of the first frame that it counted for, so that a replay follows it too.
struct PersonHint {
  enum class Kind {
    kCell,         ///< the cell is here: a point inside it
    kNeedleTip,    ///< the needle's tip is here
    kNoCell,       ///< what is here is no cell
    kHolder,       ///< the holding pipette is here: a point on it, near the cell
    kCellOutline,  ///< this is the cell's outline
    kTakeBack      ///< the latest hint in force no longer counts; no place
  };
  using Place_um = std::array<double, 2>;  ///< frame W, image plane

  Kind kind = Kind::kCell;
  double x_um = 0.0, y_um = 0.0;  ///< frame W, image plane; kept to 0.001 um; an outline's mean
  double since_s = 0.0;           ///< counts for the first frame from then on, in the session's time
  /// `kCellOutline` only: 3 to `kMostOutlinePlaces` corners of the closed outline, in any orientation.
  std::vector<Place_um> outline_um;

  bool operator==(const PersonHint&) const = default;
};

/// Corners kept of an outline: one drawn by hand is not better than that.
constexpr std::size_t kMostOutlinePlaces = 32;

/// The hint that a line drawn round the cell is: of its places `kMostOutlinePlaces` at most, evenly chosen. Nothing for
/// fewer than 3, or places that are not finite.
std::optional<PersonHint> outline_hint(std::span<const PersonHint::Place_um> drawn_um);

/// "cell at 101.250 88.300 um", "needle tip at ...", "no cell at ...", "holding pipette at ...", "cell outlined by
/// 32 places: 101.250 88.300 ... um", "taken back": how an event begins.
std::string describe(const PersonHint& hint);

/// The detail of an event as a person reads it: without an outline's corners, which are for replays.
std::string without_corners(const std::string& detail);

/// The hint in an event; nothing for another kind of event, or words that are none.
std::optional<PersonHint> hint_of(const Event& event);

/// What a session's text can hold: places to 0.001 um.
PersonHint as_stored(PersonHint hint);

/// An option of the command line that gives a hint.
struct HintOption {
  const char* name;
  PersonHint::Kind kind;
  const char* meaning;
};
/// "--cell-at", "--needle-tip", "--no-cell-at", "--holder-at", "--cell-outline".
std::span<const HintOption> hint_options() noexcept;

/// "X,Y" in um, or "X,Y@S" for the first frame from S seconds on; an outline as "X,Y/X,Y/X,Y" and so on, likewise.
/// Throws UsageError that names `option`.
PersonHint parse_hint(const HintOption& option, const std::string& text);

/// Those of `texts` among `hints`, in the order of time. Throws as `parse_hint`.
void add_hints(std::vector<PersonHint>& hints, const HintOption& option, std::span<const std::string> texts);

/// Puts a hint among others behind all that are no later.
void add_in_time(std::vector<PersonHint>& hints, const PersonHint& hint);

}  // namespace pellucida
