#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {

/// The tracker's errors on one frame of the virtual microscope, px but for the indentation. -1: not measured.
struct FrameError {
  CellState state = CellState::kNoCell, true_state = CellState::kNoCell;
  double confidence = 0.0;
  double outer_px = -1.0;  ///< RMS distance of the contour's points from the true contour
  double inner_px = -1.0;
  double outer_max_px = -1.0;
  double tip_px = -1.0;
  double center_px = -1.0;
  double indentation_um = 0.0;  ///< measured minus true
  double true_indentation_um = 0.0;
  double direction_rad = -1.0;  ///< angle between the needle's directions
  double covered_ratio = 0.0;   ///< share of the contour points whose error is within their sigma
  double sharp_ratio = 0.0;     ///< share of contour points with confidence above 0.5
};

/// Root of the mean square, and the largest, of one error over frames that have it.
struct ErrorSummary {
  double rms = 0.0;
  double largest = 0.0;
  int count = 0;
  int missing = 0;
};

using FrameHook = std::function<void(const Frame&, const Observation&, const Truth&, const FrameError&)>;

/// Runs a tracker over a scenario; every `stride`-th frame is given to it. The hook (may be empty) sees each frame.
std::vector<FrameError> run_scenario(const Scenario& scenario, MembraneTracker& tracker, int stride = 1,
                                     const FrameHook& hook = {});

FrameError compare(const Observation& measured, const Observation& truth, double pixel_size_um);

ErrorSummary summarize(const std::vector<FrameError>& errors, double FrameError::*member);
/// RMS of the indentation's error over the frames truly in contact that were reported so.
ErrorSummary summarize_indentation(const std::vector<FrameError>& errors);

}  // namespace pellucida::test
