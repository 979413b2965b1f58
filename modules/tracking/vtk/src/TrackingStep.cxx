#include "pellucida/tracking_vtk/TrackingStep.h"

#include <cstdio>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {

std::optional<Event> event_of_change(std::optional<CellState> state_before, const Observation& now) {
  const CellState before = state_before.value_or(CellState::kNoCell);
  if (before == now.state) return std::nullopt;
  const bool had_cell = before != CellState::kNoCell && before != CellState::kLost;
  char detail[160] = "";
  const auto event = [&](const char* kind) { return Event{now.time_s, kind, detail}; };
  switch (now.state) {
    case CellState::kLost:
      return event("lost");
    case CellState::kNoCell:
      return std::nullopt;
    case CellState::kContact:
      if (now.needle)
        std::snprintf(detail, sizeof detail, "tip at %.1f %.1f um, confidence %.2f", now.needle->tip_um.x(),
                      now.needle->tip_um.y(), now.confidence);
      return event(had_cell ? "contact" : "found");
    case CellState::kPunctured:
      std::snprintf(detail, sizeof detail, "membrane left at %.1f um", now.indentation_um);
      return event("puncture");
    case CellState::kFree:
      if (had_cell) return event("release");
      std::snprintf(detail, sizeof detail, "cell at %.1f %.1f um, radius %.1f um, confidence %.2f", now.center_um.x(),
                    now.center_um.y(), now.rest_outer_radius_um, now.confidence);
      return event("found");
  }
  return std::nullopt;
}

expected<Scene, StepFailure> TrackingStep::process(const Scene& scene) {
  if (!scene.frame) return unexpected<StepFailure>(StepFailure{"the scene has no frame to track"});
  if (scene.run_index != run_index_) {
    run_index_ = scene.run_index;
    reset();
  }
  auto observation = std::make_shared<const Observation>(tracker_.process(
      view_of(scene.frame.get()), stamped_time_s(scene.frame.get()), stamped_frame_index(scene.frame.get())));

  Scene result = scene;
  result.membranes = Frozen<vtkPolyData>(make_membranes(*observation));
  result.tools = Frozen<vtkPolyData>(make_tools(*observation));
  result.measurement = measurement_from(*observation);
  if (auto event = event_of_change(state_, *observation)) result.events.push_back(std::move(*event));
  state_ = observation->state;
  result.observation = std::move(observation);
  return result;
}

void TrackingStep::reset() {
  tracker_.reset();
  state_.reset();
}

}  // namespace pellucida
