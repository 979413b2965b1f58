#pragma once
#include <string>
#include <vector>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Palette.h"
#include "presenters/RecordedSession.h"

namespace pellucida {

/// A row of the list beside the views, and a mark on the timeline.
struct ReviewEvent {
  double time_s = 0.0;
  std::string kind;  ///< as in `events.csv`, or `kDoubtKind`
  std::string text;
  double end_s = 0.0;  ///< of a doubt: until when it holds; else `time_s`
  bool is_doubt = false;
};

/// The kind of what the rows say against themselves, beside the kinds of `events.csv`.
inline constexpr const char* kDoubtKind = PELLUCIDA_WORDS("doubt");
/// That of a note written afterwards (session/Annotations.h).
inline constexpr const char* kAnnotationKind = PELLUCIDA_WORDS("annotation");

/// Below this the confidence of a frame is low: the readouts show it in amber.
inline constexpr double kLowConfidence_ratio = 0.5;

/// The session's events, and the doubts that follow from its rows: stretches of low confidence, of contact without a
/// force, of frames that were not measured; in the order of time. A `warning` is a doubt from its time until the
/// contact ends.
std::vector<ReviewEvent> review_events(const RecordedSession& session);

/// The kinds that occur, each once, those of `events.csv` in their order there, others after them.
std::vector<std::string> kinds_of(const std::vector<ReviewEvent>& events);

/// Colour of a kind's mark.
Color event_color(const ReviewEvent& event);

/// The doubts that hold at a time, in one line; empty for none.
std::string doubts_at(const std::vector<ReviewEvent>& events, double time_s);

/// The step before (`forwards` false) or after `step` at which the nearest event begins; `step` itself where there is
/// none.
std::size_t neighbour_event_step(const RecordedSession& session, const std::vector<ReviewEvent>& events,
                                 std::size_t step, bool forwards);

}  // namespace pellucida
