#include "pellucida/operation/LimitDigest.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace pellucida {
namespace {

// Unit of what a limit compares; empty where it compares nothing.
const char* unit_of(LimitKind kind) {
  switch (kind) {
    case LimitKind::kDepth:
    case LimitKind::kTravel:
    case LimitKind::kFollowing:
      return "um";
    case LimitKind::kForce:
      return "uN";
    case LimitKind::kSpeed:
      return "um/s";
    case LimitKind::kHandForce:
      return "N";
    case LimitKind::kHandStiffness:
      return "N/m";
    case LimitKind::kContactStale:
    case LimitKind::kLateTick:
      return "s";
    default:
      return "";
  }
}

std::string begin_text(const LimitEvent& limit) {
  const std::string name(to_string(limit.kind));
  const char* unit = unit_of(limit.kind);
  if (*unit == '\0' || limit.limit == 0.0) return name;
  char text[96];
  std::snprintf(text, sizeof text, ": %.3g %s, limit %.3g %s", limit.value, unit, limit.limit, unit);
  return name + text;
}

}  // namespace

void LimitDigest::add(const LimitEvent& limit) {
  Stretch& stretch = stretches_[static_cast<std::size_t>(limit.kind)];
  if (!limit.begun) {
    stretch.acting = false;
    stretch.end_s = limit.time_s;
    return;
  }
  if (!stretch.reported) {
    stretch = {.reported = true, .begin_s = limit.time_s};
    waiting_.push_back({limit.time_s, event_kind::kLimit, begin_text(limit)});
  }
  stretch.acting = true;
  ++stretch.count;
  if (std::abs(limit.value) > std::abs(stretch.peak)) stretch.peak = limit.value;
}

std::vector<Event> LimitDigest::take(double now_s, double session_lag_s) {
  for (std::size_t i = 0; i < stretches_.size(); ++i) {
    Stretch& stretch = stretches_[i];
    if (!stretch.reported || stretch.acting || now_s - stretch.end_s < kQuiet_s) continue;
    const auto kind = static_cast<LimitKind>(i);
    std::string detail = std::string(to_string(kind)) + ": over";
    if (stretch.count > 1) {
      char text[96];
      std::snprintf(text, sizeof text, ", acted %ld times in %.3g s", stretch.count, stretch.end_s - stretch.begin_s);
      detail += text;
      if (*unit_of(kind) != '\0' && stretch.peak != 0.0) {
        std::snprintf(text, sizeof text, ", at most %.3g %s", stretch.peak, unit_of(kind));
        detail += text;
      }
    }
    waiting_.push_back({stretch.end_s, event_kind::kLimit, std::move(detail)});
    stretch.reported = false;
  }
  std::vector<Event> events = std::exchange(waiting_, {});
  for (Event& event : events) event.time_s -= session_lag_s;
  return events;
}

std::vector<Event> LimitDigest::finish(double session_lag_s) {
  return take(std::numeric_limits<double>::infinity(), session_lag_s);
}

}  // namespace pellucida
