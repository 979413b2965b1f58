#pragma once
#include <optional>
#include <span>

#include "pellucida/core/Event.h"
#include "presenters/GaugePresenter.h"

namespace pellucida {

enum class SoundCue { kContact, kPuncture, kAlarm };

/// What of a run is worth a sound: the touch, the puncture, and a gauge that reached its limit or lost its number.
class CueFinder {
 public:
  /// The run's next events and the gauges as they are; `now_s` is any monotonic clock. The gravest one: alarms come no
  /// more often than every two seconds.
  std::optional<SoundCue> take(std::span<const Event> events, std::span<const Gauge> gauges, double now_s);

 private:
  bool was_alarmed_ = true;  // nothing is known at first: no alarm
  std::optional<double> alarm_s_;
};

}  // namespace pellucida
