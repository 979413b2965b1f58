#pragma once
#include <string>
#include <vector>

#include "tracking/GridConditions.h"
#include "tracking/ScenarioRun.h"

namespace pellucida::test {

/// Quantiles of one error over the frames that have it, and how many have not.
struct Spread {
  double median = 0.0, p95 = 0.0, largest = 0.0;
  int missing = 0;
};
/// `values`: below 0 is missing.
Spread spread_of(std::vector<double> values);

/// What the tracker did under one condition, or under several together.
struct GridRow {
  std::string name;
  int frames = 0;
  Spread outer_px, inner_px, tip_px;  ///< of each frame's RMS over the contour; of its tip
  double indentation_rms_um = 0.0;    ///< over frames in contact that were reported so
  Coverage outer_coverage, inner_coverage, dimple_coverage, tip_coverage, depth_coverage;
  int confident_and_wrong = 0;   ///< confidence above 0.8 and a contour more than 2 px off
  int lost = 0;                  ///< frames reported as lost or without a cell
  int wrong_states = 0;          ///< of the others, frames whose state differs from the truth
  double median_frame_ms = 0.0;  ///< the tracker's time, for orientation only
};

/// Errors of all frames the tracker saw under a condition, and its times.
struct GridRun {
  std::vector<FrameError> errors;
  std::vector<double> frame_ms;
};
GridRun run_condition(const GridCondition& condition);

GridRow summarize_run(const std::string& name, const GridRun& run);

}  // namespace pellucida::test
