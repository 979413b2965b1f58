#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {

/// How many of how many errors lie within their standard deviation: 0.68 where the sigmas are honest.
struct Coverage {
  int covered = 0, count = 0;
  double ratio() const { return count > 0 ? static_cast<double>(covered) / count : 0.0; }
  Coverage& operator+=(const Coverage& other) {
    covered += other.covered;
    count += other.count;
    return *this;
  }
};

/// The tracker's errors on one frame of the virtual microscope, px but for the indentation. -1: not measured.
struct FrameError {
  CellState state = CellState::kNoCell, true_state = CellState::kNoCell;
  double confidence = 0.0;
  double outer_px = -1.0;  ///< RMS distance of the contour's points from the true contour
  double inner_px = -1.0;
  double oolemma_px = -1.0;
  double outer_max_px = -1.0;
  double tip_px = -1.0;
  double center_px = -1.0;
  double indentation_um = 0.0;  ///< measured minus true
  double true_indentation_um = 0.0;
  double rotation_rad = 0.0;    ///< measured minus true
  double direction_rad = -1.0;  ///< angle between the needle's directions
  Coverage outer_coverage, inner_coverage;
  Coverage dimple_coverage;  ///< of both contours' points inside the dimple's mouth
  Coverage tip_coverage;     ///< of the tip's error along the needle; empty when no sigma is given
  Coverage depth_coverage;   ///< of the indentation's error, in contact
  double sharp_ratio = 0.0;  ///< share of contour points with confidence above 0.5
  /// The one thing that must not be: confidence above 0.8 and a contour more than 2 px off.
  bool confident_and_wrong() const { return confidence > 0.8 && (outer_px > 2.0 || inner_px > 2.0); }
  double covered_ratio() const { return Coverage(outer_coverage).operator+=(inner_coverage).ratio(); }
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
