#include "tracking/ScenarioRun.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/tracking/ContourMath.h"

namespace pellucida::test {
namespace {

double contour_error(const MembraneContour& measured, const MembraneContour& truth, double pixel_size_um,
                     double* largest, int& covered, int& count) {
  double squares = 0.0;
  for (Eigen::Index i = 0; i < measured.points_um.cols(); ++i) {
    const double distance = contour::distance_to(truth.points_um, measured.points_um.col(i));
    squares += distance * distance;
    if (largest) *largest = std::max(*largest, distance / pixel_size_um);
    covered += distance <= measured.sigma_um[i] ? 1 : 0;
    ++count;
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
  int covered = 0, count = 0;
  if (measured.outer) {
    error.outer_px = contour_error(*measured.outer, *truth.outer, pixel_size_um, &error.outer_max_px, covered, count);
    error.center_px = (measured.center_um - truth.center_um).norm() / pixel_size_um;
    error.sharp_ratio = (measured.outer->confidence.array() > 0.5).cast<double>().mean();
  }
  if (measured.inner)
    error.inner_px = contour_error(*measured.inner, *truth.inner, pixel_size_um, nullptr, covered, count);
  error.covered_ratio = count > 0 ? static_cast<double>(covered) / count : 0.0;
  if (measured.needle) {
    error.tip_px = (measured.needle->tip_um - truth.needle->tip_um).norm() / pixel_size_um;
    error.direction_rad = std::acos(std::clamp(measured.needle->direction.dot(truth.needle->direction), -1.0, 1.0));
    error.indentation_um = measured.indentation_um - truth.indentation_um;
  }
  return error;
}

std::vector<FrameError> run_scenario(const Scenario& scenario, MembraneTracker& tracker, int stride,
                                     const FrameHook& hook) {
  VirtualMicroscope microscope(scenario);
  std::vector<FrameError> errors;
  while (const std::optional<Frame> frame = microscope.next()) {
    if (frame->frame_index % stride != 0) continue;
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    errors.push_back(compare(seen, microscope.truth().observation, scenario.image.pixel_size_um));
    if (hook) hook(*frame, seen, microscope.truth(), errors.back());
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
