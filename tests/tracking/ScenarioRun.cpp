#include "tracking/ScenarioRun.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida::test {
namespace {

// Inside the dimple's mouth: on the needle's side, no farther from its axis than the crests.
bool in_dimple(const Observation& truth, const Eigen::Vector2d& point_um) {
  if (truth.dimple_radius_um <= 0.0) return false;
  const Eigen::Vector2d from = point_um - truth.center_um;
  const double across = truth.axis.x() * from.y() - truth.axis.y() * from.x();
  return from.dot(truth.axis) > 0.0 && std::abs(across) < truth.dimple_radius_um;
}

// RMS distance of a contour's points from the true one, px.
double contour_error(const MembraneContour& measured, const MembraneContour& true_contour, const Observation& truth,
                     double pixel_size_um, double& largest_px, Coverage& all, Coverage& dimple) {
  double squares = 0.0;
  const bool has_sigma = measured.sigma_um.size() == measured.points_um.cols();
  for (Eigen::Index i = 0; i < measured.points_um.cols(); ++i) {
    const double distance = contour::distance_to(true_contour.points_um, measured.points_um.col(i));
    squares += distance * distance;
    largest_px = std::max(largest_px, distance / pixel_size_um);
    if (!has_sigma) continue;
    const Coverage one{distance <= measured.sigma_um[i] ? 1 : 0, 1};
    all += one;
    if (in_dimple(truth, measured.points_um.col(i))) dimple += one;
  }
  return std::sqrt(squares / static_cast<double>(std::max<Eigen::Index>(1, measured.points_um.cols()))) / pixel_size_um;
}

}  // namespace

FrameError compare(const Observation& measured, const Observation& truth, double pixel_size_um) {
  FrameError error;
  error.state = measured.state;
  error.true_state = truth.state;
  error.confidence = measured.confidence;
  error.true_indentation_um = truth.indentation_um;
  if (measured.outer) {
    error.outer_px = contour_error(*measured.outer, *truth.outer, truth, pixel_size_um, error.outer_max_px,
                                   error.outer_coverage, error.dimple_coverage);
    error.center_px = (measured.center_um - truth.center_um).norm() / pixel_size_um;
    error.rotation_rad = measured.rotation_rad - truth.rotation_rad;
    error.sharp_ratio = (measured.outer->confidence.array() > 0.5).cast<double>().mean();
  }
  if (measured.inner) {
    double largest_px = 0.0;
    error.inner_px = contour_error(*measured.inner, *truth.inner, truth, pixel_size_um, largest_px,
                                   error.inner_coverage, error.dimple_coverage);
  }
  if (measured.oolemma && truth.oolemma) {
    double largest_px = 0.0;
    Coverage all, dimple;
    error.oolemma_px = contour_error(*measured.oolemma, *truth.oolemma, truth, pixel_size_um, largest_px, all, dimple);
  }
  if (measured.needle) {
    const Eigen::Vector2d off_um = measured.needle->tip_um - truth.needle->tip_um;
    error.tip_px = off_um.norm() / pixel_size_um;
    if (measured.needle->tip_sigma_um > 0.0) {
      const double along_um = std::abs(off_um.dot(truth.needle->direction));
      error.tip_coverage = {along_um <= measured.needle->tip_sigma_um ? 1 : 0, 1};
    }
    error.direction_rad = std::acos(std::clamp(measured.needle->direction.dot(truth.needle->direction), -1.0, 1.0));
    error.indentation_um = measured.indentation_um - truth.indentation_um;
    if (measured.indentation_sigma_um > 0.0 && measured.state == CellState::kContact &&
        truth.state == CellState::kContact)
      error.depth_coverage = {std::abs(error.indentation_um) <= measured.indentation_sigma_um ? 1 : 0, 1};
  }
  return error;
}

std::vector<FrameError> run_scenario(const Scenario& scenario, MembraneTracker& tracker, int stride,
                                     const FrameHook& hook) {
  VirtualMicroscope microscope(scenario);
  std::vector<FrameError> errors;
  while (const std::optional<Frame> frame = microscope.next()) {
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    errors.push_back(compare(seen, microscope.truth().observation, scenario.image.pixel_size_um));
    if (hook) hook(*frame, seen, microscope.truth(), errors.back());
    for (int skipped = 1; skipped < stride; ++skipped) microscope.skip();
  }
  return errors;
}

ErrorSummary summarize(const std::vector<FrameError>& errors, double FrameError::*member) {
  ErrorSummary summary;
  double squares = 0.0;
  for (const FrameError& e : errors) {
    if (e.*member < 0.0) {
      ++summary.missing;
      continue;
    }
    squares += e.*member * e.*member;
    summary.largest = std::max(summary.largest, e.*member);
    ++summary.count;
  }
  summary.rms = summary.count > 0 ? std::sqrt(squares / summary.count) : 0.0;
  return summary;
}

ErrorSummary summarize_indentation(const std::vector<FrameError>& errors) {
  ErrorSummary summary;
  double squares = 0.0;
  for (const FrameError& e : errors) {
    if (e.true_state != CellState::kContact) continue;
    if (e.tip_px < 0.0) {
      ++summary.missing;
      continue;
    }
    squares += e.indentation_um * e.indentation_um;
    summary.largest = std::max(summary.largest, std::abs(e.indentation_um));
    ++summary.count;
  }
  summary.rms = summary.count > 0 ? std::sqrt(squares / summary.count) : 0.0;
  return summary;
}

}  // namespace pellucida::test
