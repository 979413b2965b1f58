#pragma once
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "presenters/ReviewEvents.h"

namespace pellucida {

/// A stretch of the session's time in which the state of the cell didn't change; nothing: not measured.
struct TimelineSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
  std::optional<CellState> state;
};

/// What the timeline shows.
struct Timeline {
  double begin_s = 0.0;
  double end_s = 0.0;               ///< greater than `begin_s`
  std::vector<TimelineSpan> spans;  ///< in the order of time; between two of them nothing was recorded
  std::vector<ReviewEvent> events;  ///< marks; those with `is_doubt` stretches too
};

/// Rows further apart than half a second and than five usual steps leave a hole.
Timeline timeline_of(const RecordedSession& session, const std::vector<ReviewEvent>& events);

/// The states that occur, in the order of `CellState`.
std::vector<CellState> states_in(const Timeline& timeline);

/// What the timeline says of a place: the time, the state, events within `reach_s` of it, doubts that hold there; lines
/// of plain text.
std::string timeline_tip(const Timeline& timeline, double time_s, double reach_s);

}  // namespace pellucida
