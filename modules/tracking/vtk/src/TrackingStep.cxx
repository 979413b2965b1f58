#include "pellucida/tracking_vtk/TrackingStep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/ObservationData.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

template <class... Numbers>
std::string format(const char* pattern, Numbers... numbers) {
  char text[192];
  std::snprintf(text, sizeof text, pattern, numbers...);
  return text;
}

// A session's times are those of its frames but for their last digits.
constexpr double kHintTolerance_s = 5e-4;

Contour_um outline_of(const PersonHint& hint) {
  Contour_um outline_um(2, static_cast<Eigen::Index>(hint.outline_um.size()));
  for (Eigen::Index k = 0; k < outline_um.cols(); ++k) {
    const PersonHint::Place_um& place = hint.outline_um[static_cast<std::size_t>(k)];
    outline_um.col(k) << place[0], place[1];
  }
  return outline_um;
}

void give(MembraneTracker& tracker, const PersonHint& hint) {
  const Eigen::Vector2d place_um(hint.x_um, hint.y_um);
  switch (hint.kind) {
    case PersonHint::Kind::kCell:
      tracker.expect_cell({.inside_um = place_um, .outline_um = std::nullopt});
      break;
    case PersonHint::Kind::kNeedleTip:
      tracker.expect_needle(place_um);
      break;
    case PersonHint::Kind::kHolder:
      tracker.expect_holder(place_um);
      break;
    case PersonHint::Kind::kCellOutline:
      tracker.expect_cell({.inside_um = std::nullopt, .outline_um = outline_of(hint)});
      break;
    case PersonHint::Kind::kNoCell:
      tracker.exclude_cell(place_um);
      break;
    case PersonHint::Kind::kTakeBack:
      tracker.take_back_hint();
      break;
  }
}

const std::string& outcome_of(PersonHint::Kind kind, const HintOutcomes& outcomes) {
  static const std::string kNone;
  switch (kind) {
    case PersonHint::Kind::kCell:
    case PersonHint::Kind::kCellOutline:
      return outcomes.cell;
    case PersonHint::Kind::kNeedleTip:
      return outcomes.needle;
    case PersonHint::Kind::kHolder:
      return outcomes.holder;
    case PersonHint::Kind::kNoCell:
    case PersonHint::Kind::kTakeBack:
      break;
  }
  return kNone;
}

// Whether a session's event holds it.
bool is_kept(const PersonHint& hint) {
  return hint_of({hint.since_s, event_kind::kHint, describe(hint)}).has_value();
}

// Where the cell is, and, where only one of the zona's edges was seen, that the other was not.
std::string what_was_found(const Observation& now) {
  std::string detail = format("cell at %.1f %.1f um, radius %.1f um, confidence %.2f", now.center_um.x(),
                              now.center_um.y(), now.rest_outer_radius_um, now.confidence);
  if (!now.inner) detail += "; one membrane only, taken as the outer: no second edge was seen beside it";
  if (now.state != CellState::kFree) detail += "; seen first as " + std::string(to_string(now.state));
  return detail;
}

}  // namespace

std::optional<Event> event_of_change(std::optional<CellState> state_before, const Observation& now) {
  const CellState before = state_before.value_or(CellState::kNoCell);
  if (before == now.state) return std::nullopt;
  const auto event = [&](const char* kind, std::string detail) { return Event{now.time_s, kind, std::move(detail)}; };
  if (now.state == CellState::kNoCell) return std::nullopt;
  if (now.state == CellState::kLost) return event(event_kind::kLost, "");
  if (before == CellState::kNoCell || before == CellState::kLost) return event(event_kind::kFound, what_was_found(now));
  switch (now.state) {
    case CellState::kContact:
      return event(event_kind::kContact, now.needle
                                             ? format("tip at %.1f %.1f um, confidence %.2f", now.needle->tip_um.x(),
                                                      now.needle->tip_um.y(), now.confidence)
                                             : "");
    case CellState::kPunctured:
      return event(event_kind::kPuncture, format("membrane left at %.1f um", now.indentation_um));
    default:
      return event(event_kind::kRelease, "");
  }
}

expected<Scene, StepFailure> TrackingStep::process(const Scene& scene) {
  if (!scene.frame) return unexpected<StepFailure>(StepFailure{"the scene has no frame to track"});
  if (scene.run_index != run_index_) {
    run_index_ = scene.run_index;
    reset();
  }
  const double time_s = stamped_time_s(scene.frame.get());
  const std::vector<PersonHint> hints = due_hints(time_s);
  for (const PersonHint& hint : hints) give(tracker_, hint);
  auto tracked = std::make_shared<Observation>(tracker_.process(
      view_of(scene.frame.get()), time_s, stamped_frame_index(scene.frame.get()), hints_of(scene.measurement)));
  // What a session can't hold, no later step sees: a recording gives the same force as the live image.
  round_as_stored(*tracked);
  const std::shared_ptr<const Observation> observation = std::move(tracked);

  Scene result = scene;
  result.membranes = Frozen<vtkPolyData>(make_membranes(*observation));
  result.tools = Frozen<vtkPolyData>(make_tools(*observation));
  result.measurement = measurement_from(*observation);
  result.measurement.manipulator_x_um = scene.measurement.manipulator_x_um;
  result.measurement.manipulator_y_um = scene.measurement.manipulator_y_um;
  for (const PersonHint& hint : hints) {
    std::string detail = describe(hint);
    if (const std::string& outcome = outcome_of(hint.kind, tracker_.hint_outcomes()); !outcome.empty())
      detail += ": " + outcome;
    result.events.push_back({time_s, event_kind::kHint, std::move(detail)});
  }
  if (auto event = event_of_change(state_, *observation)) result.events.push_back(std::move(*event));
  state_ = observation->state;
  result.observation = observation;
  return result;
}

void TrackingStep::add_hint(const PersonHint& hint) {
  if (!std::isfinite(hint.x_um) || !std::isfinite(hint.y_um) || !std::isfinite(hint.since_s)) {
    throw UsageError("hint: its place or time is not finite; give a point of the image, um");
  }
  if (hint.kind == PersonHint::Kind::kCellOutline && !is_kept(hint)) {
    throw UsageError("hint: the cell's outline has " + std::to_string(hint.outline_um.size()) +
                     " corners, or one that is not finite; give 3 to " + std::to_string(kMostOutlinePlaces));
  }
  const std::lock_guard lock(mutex_);
  hints_.push_back(as_stored(hint));
}

std::vector<PersonHint> TrackingStep::due_hints(double time_s) {
  const std::lock_guard lock(mutex_);
  const auto first_later = std::find_if(
      hints_.begin(), hints_.end(), [&](const PersonHint& hint) { return hint.since_s > time_s + kHintTolerance_s; });
  std::vector<PersonHint> due(hints_.begin(), first_later);
  hints_.erase(hints_.begin(), first_later);
  return due;
}

FrameHints TrackingStep::hints_of(const Measurement& row) {
  const Eigen::Vector2d now_um(row.manipulator_x_um, row.manipulator_y_um);
  FrameHints hints;
  if (now_um.allFinite() && manipulator_um_) hints.needle_motion_um = now_um - *manipulator_um_;
  manipulator_um_ = now_um.allFinite() ? std::optional(now_um) : std::nullopt;
  return hints;
}

void TrackingStep::reset() {
  tracker_.reset();
  manipulator_um_.reset();
  state_.reset();
}

}  // namespace pellucida
