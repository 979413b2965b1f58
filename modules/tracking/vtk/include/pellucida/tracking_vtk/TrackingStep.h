#pragma once
#include <optional>

#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {

/// The tracker as a step: a scene with a frame becomes a scene with contours, tools, the tracker's part of the
/// measurement and the events of this frame: `contact`, `release`, `puncture`, `lost`, `found`. Has memory: frames in
/// order, one thread at a time.
class TrackingStep {
 public:
  using Input = Scene;
  using Output = Scene;

  explicit TrackingStep(TrackerOptions options = {}) : tracker_(options) {}

  /// Fails when the scene has no frame. A frame without a cell is not a failure: its state shows it.
  expected<Scene, StepFailure> process(const Scene& scene);

  /// Forgets what was tracked.
  void reset();

 private:
  MembraneTracker tracker_;
  std::optional<CellState> state_;
  long run_index_ = 0;
};

static_assert(Step<TrackingStep>);

/// The event due to a change of state: nothing when none is due (`state_before` empty: before the first frame).
std::optional<Event> event_of_change(std::optional<CellState> state_before, const Observation& now);

}  // namespace pellucida
