#include "LiveScale.h"

#include <algorithm>
#include <utility>

#include "pellucida/pipeline/RunProvenance.h"

namespace pellucida {
namespace {

/// A new scale counts from frames so much later than the newest one: those on their way are measured as before, in a
/// replay too.
constexpr double kScaleDelay_s = 0.2;

}  // namespace

LiveScale::LiveScale(MechanicsStep& mechanics, RunRecording& recording, const CellProfile& profile,
                     std::vector<ScaleMeasurement> measurements)
    : mechanics_(mechanics),
      recording_(recording),
      profile_(profile),
      measurements_(std::move(measurements)),
      scale_(scale_before(profile)) {}

Event LiveScale::add(ScaleMeasurement measurement, double newest_time_s) {
  measurement.since_s = newest_time_s + kScaleDelay_s;
  {
    std::lock_guard lock(mutex_);
    std::vector<ScaleMeasurement> all = measurements_;
    all.push_back(measurement);
    mechanics_.set_scale_measurements(all);
    measurements_ = std::move(all);
  }
  record();
  return {newest_time_s, event_kind::kPalpation, "measured: " + describe(measurement)};
}

Event LiveScale::forget(double newest_time_s) {
  std::lock_guard lock(mutex_);
  measurements_.clear();
  scale_ = scale_before(profile_);
  mechanics_.set_scale_measurements({});
  recording_.set_palpation({});
  return {newest_time_s, event_kind::kPalpation, "forgotten: the kind's scale again"};
}

void LiveScale::take(const std::vector<Event>& events) {
  const bool is_learnt = std::any_of(events.begin(), events.end(),
                                     [](const Event& event) { return event.kind == event_kind::kPalpation; });
  if (!is_learnt) return;
  {
    std::lock_guard lock(mutex_);
    scale_ = mechanics_.scale();
  }
  record();
}

void LiveScale::record() {
  std::lock_guard lock(mutex_);
  if (!measurements_.empty()) recording_.set_palpation(palpation_json(measurements_, scale_, {}));
}

}  // namespace pellucida
