#include "presenters/TimelinePresenter.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/MessageBook.h"

namespace pellucida {
namespace {

constexpr double kLeastHole_s = 0.5;
constexpr double kHoleSteps = 5.0;
constexpr double kLeastLength_s = 1e-3;
// Lines a tip has at most; a crowd of events would cover the window.
constexpr std::size_t kMostLines = 8;

}  // namespace

Timeline timeline_of(const RecordedSession& session, const std::vector<ReviewEvent>& events) {
  Timeline timeline;
  timeline.begin_s = session.begin_s();
  timeline.end_s = std::max(session.end_s(), timeline.begin_s + kLeastLength_s);
  timeline.events = events;
  const double usual_s = session.usual_step_s();
  const double hole_s = std::max(kLeastHole_s, kHoleSteps * usual_s);
  for (std::size_t i = 0; i < session.step_count(); ++i) {
    const double begin_s = session.times_s[i];
    const bool last = i + 1 == session.step_count();
    double end_s = last ? timeline.end_s : session.times_s[i + 1];
    if (end_s - begin_s > hole_s) end_s = begin_s + usual_s;
    auto& spans = timeline.spans;
    const bool joined = !spans.empty() && spans.back().state == session.rows[i].state && spans.back().end_s == begin_s;
    if (joined) {
      spans.back().end_s = end_s;
    } else {
      spans.push_back({begin_s, end_s, session.rows[i].state});
    }
  }
  return timeline;
}

std::vector<CellState> states_in(const Timeline& timeline) {
  std::vector<CellState> states;
  for (const TimelineSpan& span : timeline.spans) {
    if (span.state && std::find(states.begin(), states.end(), *span.state) == states.end()) {
      states.push_back(*span.state);
    }
  }
  std::sort(states.begin(), states.end());
  return states;
}

std::string timeline_tip(const Timeline& timeline, double time_s, double reach_s) {
  std::string tip = readout::time(time_s);
  const auto span = std::find_if(timeline.spans.begin(), timeline.spans.end(),
                                 [&](const auto& one) { return one.begin_s <= time_s && time_s <= one.end_s; });
  if (span == timeline.spans.end()) {
    tip += say(": nothing recorded");
  } else {
    tip += ": " + (span->state ? readout::state(span->state) : say("not measured"));
  }
  std::size_t lines = 0, more = 0;
  for (const ReviewEvent& event : timeline.events) {
    const bool near = std::abs(event.time_s - time_s) <= reach_s;
    const bool holds = event.is_doubt && event.time_s <= time_s && time_s <= event.end_s;
    if (!near && !holds) continue;
    if (lines == kMostLines) {
      ++more;
      continue;
    }
    ++lines;
    tip.append("\n").append(readout::time(event.time_s)).append("  ").append(say_event_kind(event.kind));
    if (!event.text.empty()) tip.append(": ").append(event.text);
  }
  if (more > 0) tip.append(say("\nand ")).append(std::to_string(more)).append(say(" more"));
  return tip;
}

}  // namespace pellucida
