#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pellucida/core/Event.h"

namespace pellucida {

/// What a person says of the image by a click: where something is, or is not. The session keeps it as an event `hint`
/// of the first frame that it counted for, so that a replay follows it too.
struct PersonHint {
  enum class Kind {
    kCell,       ///< the cell is here: a point inside it
    kNeedleTip,  ///< the needle's tip is here
    kNoCell,     ///< what is here is no cell
    kTakeBack    ///< the latest hint in force no longer counts; no place
  };
  Kind kind = Kind::kCell;
  double x_um = 0.0, y_um = 0.0;  ///< frame W, image plane; kept to 0.001 um
  double since_s = 0.0;           ///< counts for the first frame from then on, in the session's time

  bool operator==(const PersonHint&) const = default;
};

/// "cell at 101.250 88.300 um", "needle tip at ...", "no cell at ...", "taken back": how an event begins.
std::string describe(const PersonHint& hint);

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
/// "--cell-at", "--needle-tip", "--no-cell-at".
std::span<const HintOption> hint_options() noexcept;

/// "X,Y" in um, or "X,Y@S" for the first frame from S seconds on. Throws UsageError that names `option`.
PersonHint parse_hint(const HintOption& option, const std::string& text);

/// Those of `texts` among `hints`, in the order of time. Throws as `parse_hint`.
void add_hints(std::vector<PersonHint>& hints, const HintOption& option, std::span<const std::string> texts);

/// Puts a hint among others behind all that are no later.
void add_in_time(std::vector<PersonHint>& hints, const PersonHint& hint);

}  // namespace pellucida
