#include "presenters/ReviewEvents.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/MessageBook.h"

namespace pellucida {
namespace {

// Until the needle is off the cell, or the cell gone, or through.
double contact_end_s(const RecordedSession& session, double time_s) {
  for (std::size_t i = session.step_at(time_s); i < session.step_count(); ++i) {
    const auto& state = session.rows[i].state;
    if (state && state != CellState::kContact && session.times_s[i] > time_s) return session.times_s[i];
  }
  return session.end_s();
}

// Each unbroken stretch of rows of which `holds` is true, as one doubt.
void add_stretches(const RecordedSession& session, const std::function<bool(const Measurement&)>& holds,
                   const std::function<std::string(std::size_t)>& words, std::vector<ReviewEvent>& events) {
  const std::size_t count = session.step_count();
  for (std::size_t i = 0; i < count; ++i) {
    if (!holds(session.rows[i])) continue;
    std::size_t end = i;
    while (end < count && holds(session.rows[end])) ++end;
    ReviewEvent doubt;
    doubt.time_s = session.times_s[i];
    doubt.end_s = session.times_s[std::min(end, count - 1)];
    doubt.kind = kDoubtKind;
    doubt.text = words(end - i);
    doubt.is_doubt = true;
    events.push_back(doubt);
    i = end;
  }
}

std::string frames_of(std::size_t count) {
  return std::to_string(count) + (count == 1 ? say(" frame") : say(" frames"));
}

}  // namespace

std::vector<ReviewEvent> review_events(const RecordedSession& session) {
  std::vector<ReviewEvent> events;
  for (const Event& event : session.events) {
    const bool is_warning = event.kind == event_kind::kWarning;
    events.push_back({event.time_s, event.kind, say_event_detail(event.kind, event.detail),
                      is_warning ? contact_end_s(session, event.time_s) : event.time_s, is_warning});
  }
  add_stretches(
      session, [](const Measurement& m) { return m.state && m.confidence < kLowConfidence_ratio; },
      [](std::size_t n) { return say("confidence below 50 % in ") + frames_of(n); }, events);
  add_stretches(
      session,
      [](const Measurement& m) { return m.state == CellState::kContact && !std::isfinite(m.contact_force_uN); },
      [](std::size_t n) { return say("contact without a force in ") + frames_of(n); }, events);
  add_stretches(
      session, [](const Measurement& m) { return !m.state; },
      [](std::size_t n) { return frames_of(n) + say(" recorded but not measured"); }, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const ReviewEvent& a, const ReviewEvent& b) { return a.time_s < b.time_s; });
  return events;
}

std::vector<std::string> kinds_of(const std::vector<ReviewEvent>& events) {
  std::vector<std::string> kinds;
  const auto occurs = [&](const std::string& kind) {
    return std::any_of(events.begin(), events.end(), [&](const ReviewEvent& event) { return event.kind == kind; });
  };
  for (const EventKindInfo& known : kEventKinds) {
    if (occurs(std::string(known.name))) kinds.emplace_back(known.name);
  }
  for (const ReviewEvent& event : events) {
    if (std::find(kinds.begin(), kinds.end(), event.kind) == kinds.end()) kinds.push_back(event.kind);
  }
  return kinds;
}

Color event_color(const ReviewEvent& event) {
  if (event.is_doubt) return current_theme().warning;
  if (event.kind == event_kind::kContact) return state_color(CellState::kContact);
  if (event.kind == event_kind::kPuncture) return state_color(CellState::kPunctured);
  if (event.kind == event_kind::kLost) return state_color(CellState::kLost);
  if (event.kind == event_kind::kLimit || event.kind == event_kind::kGap || event.kind == event_kind::kDropped ||
      event.kind == event_kind::kThinned || event.kind == event_kind::kUnmeasured ||
      event.kind == event_kind::kRevoked) {
    return current_theme().warning;
  }
  if (event.kind == event_kind::kNote || event.kind == kAnnotationKind) return current_theme().plan;
  return current_theme().text_dim;
}

std::string doubts_at(const std::vector<ReviewEvent>& events, double time_s) {
  std::string doubts;
  for (const ReviewEvent& event : events) {
    // One stretch may be a single frame.
    const bool holds = event.time_s <= time_s + 1e-6 && (time_s < event.end_s - 1e-6 || event.time_s >= time_s - 1e-6);
    if (!event.is_doubt || !holds) continue;
    doubts += (doubts.empty() ? "" : "; ") + event.text;
  }
  return doubts;
}

std::size_t neighbour_event_step(const RecordedSession& session, const std::vector<ReviewEvent>& events,
                                 std::size_t step, bool forwards) {
  std::size_t nearest = step;
  for (const ReviewEvent& event : events) {
    const std::size_t at = session.step_at(event.time_s);
    if (forwards ? at > step && (nearest == step || at < nearest) : at < step && (nearest == step || at > nearest)) {
      nearest = at;
    }
  }
  return nearest;
}

}  // namespace pellucida
