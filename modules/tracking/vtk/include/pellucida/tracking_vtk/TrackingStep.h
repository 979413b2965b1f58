#pragma once
#include <mutex>
#include <optional>
#include <vector>

#include "pellucida/core/PersonHint.h"
#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida {

/// The tracker as a step: a scene with a frame becomes a scene with contours, tools, the tracker's part of the
/// measurement and the events of this frame: `contact`, `release`, `puncture`, `lost`, `found`, `hint`. Where the
/// scene's row says where a manipulator had the needle, in this frame and the one processed before, the way between is
/// the motion commanded, and stays in the row. Has memory: frames in order, one thread at a time.
class TrackingStep {
 public:
  using Input = Scene;
  using Output = Scene;

  explicit TrackingStep(TrackerOptions options = {}) : tracker_(options) {}

  /// Fails when the scene has no frame. A frame without a cell is not a failure: its state shows it.
  expected<Scene, StepFailure> process(const Scene& scene);

  /// A person's hint: counts for the first frame from its time on, whose events report it with what came of it. From
  /// any thread; hints in the order of time. Throws UsageError for a place that is not finite.
  void add_hint(const PersonHint& hint);

  /// Forgets what was tracked; hints still to come are kept.
  void reset();

 private:
  std::vector<PersonHint> due_hints(double time_s);
  FrameHints hints_of(const Measurement& row);

  MembraneTracker tracker_;
  std::mutex mutex_;
  std::vector<PersonHint> hints_;  // still to come
  std::optional<CellState> state_;
  std::optional<Eigen::Vector2d> manipulator_um_;  // in the frame before
  long run_index_ = 0;
};

static_assert(Step<TrackingStep>);

/// The event due to a change of state: nothing when none is due (`state_before` empty: before the first frame).
std::optional<Event> event_of_change(std::optional<CellState> state_before, const Observation& now);

}  // namespace pellucida
