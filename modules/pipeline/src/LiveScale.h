#pragma once
#include <mutex>
#include <vector>

#include "RunRecording.h"
#include "pellucida/core/Event.h"
#include "pellucida/mechanics_vtk/MechanicsStep.h"

namespace pellucida {

/// The measurements of the cell's own scale in a live run: for the mechanics, and in its recordings. From any thread.
class LiveScale {
 public:
  /// All must outlive it.
  LiveScale(MechanicsStep& mechanics, RunRecording& recording, const CellProfile& profile,
            std::vector<ScaleMeasurement> measurements);

  /// Counts from a moment after `newest_time_s` on. Returns the event. Throws as `MechanicsStep`.
  Event add(ScaleMeasurement measurement, double newest_time_s);
  Event forget(double newest_time_s);
  /// On the mechanics' thread: records the scale when a frame's events say that it was learnt.
  void take(const std::vector<Event>& events);
  /// Writes what is known into the running recording and later ones.
  void record();

 private:
  MechanicsStep& mechanics_;
  RunRecording& recording_;
  const CellProfile& profile_;
  std::mutex mutex_;
  std::vector<ScaleMeasurement> measurements_;
  CellScale scale_;  // the newest known
};

}  // namespace pellucida
