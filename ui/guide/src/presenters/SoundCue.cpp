#include "presenters/SoundCue.h"

#include <algorithm>

namespace pellucida {
namespace {

constexpr double kAlarmPeriod_s = 2.0;

bool has_kind(std::span<const Event> events, const char* kind) {
  return std::any_of(events.begin(), events.end(), [kind](const Event& event) { return event.kind == kind; });
}

}  // namespace

std::optional<SoundCue> CueFinder::take(std::span<const Event> events, std::span<const Gauge> gauges, double now_s) {
  const bool is_alarmed = std::any_of(gauges.begin(), gauges.end(), [](const Gauge& gauge) {
    return gauge.level == GaugeLevel::kOver || gauge.level == GaugeLevel::kNone;
  });
  const bool begins = is_alarmed && !was_alarmed_;
  was_alarmed_ = is_alarmed;
  if (begins && (!alarm_s_ || now_s - *alarm_s_ >= kAlarmPeriod_s)) {
    alarm_s_ = now_s;
    return SoundCue::kAlarm;
  }
  if (has_kind(events, event_kind::kPuncture)) return SoundCue::kPuncture;
  if (has_kind(events, event_kind::kContact)) return SoundCue::kContact;
  return std::nullopt;
}

}  // namespace pellucida
