#include "integration/ForceRun.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"
#include "pellucida/tracking/MembraneTracker.h"

namespace pellucida::test {

double ForceRun::rms_percent_of_peak() const {
  double squares = 0.0;
  for (const ForceFrame& f : frames) squares += std::pow(f.force_uN - f.true_force_uN, 2);
  return frames.empty() ? 0.0 : 100.0 * std::sqrt(squares / static_cast<double>(frames.size())) / peak_uN;
}

int ForceRun::contact_count() const {
  return static_cast<int>(
      std::count_if(frames.begin(), frames.end(), [](const auto& f) { return f.true_state == CellState::kContact; }));
}

int ForceRun::covered_count() const {
  return static_cast<int>(std::count_if(frames.begin(), frames.end(), [](const auto& f) {
    return f.true_state == CellState::kContact && f.is_covered();
  }));
}

double ForceFrame::covered_share_of_kind() const {
  if (!is_measured || !(true_force_uN > 0.0) || !(upper_uN > lower_uN)) return 0.0;
  const auto share_below = [&](double bound_uN) {
    if (!(bound_uN > 0.0)) return 0.0;
    return 0.5 * std::erfc(-std::log(bound_uN / true_force_uN) / scale_ratio / std::sqrt(2.0));
  };
  return share_below(upper_uN) - share_below(lower_uN);
}

double ForceRun::covered_share_of_kind() const {
  double sum = 0.0;
  for (const ForceFrame& f : frames) sum += f.true_state == CellState::kContact ? f.covered_share_of_kind() : 0.0;
  return sum / contact_count();
}

CellProfile profile_of(const Scenario& scenario) {
  return load_profile(scenario.cell.reference);
}

ForceRun run_force(const Scenario& scenario, const CellProfile& profile, const ForceOptions& options) {
  VirtualMicroscope microscope(scenario);
  MembraneTracker tracker;
  ForceObserver observer(profile, options);
  ForceRun run;
  while (const std::optional<Frame> frame = microscope.next()) {
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    ForceEstimate estimate = observer.process(seen);
    const Truth& truth = microscope.truth();
    ForceFrame row;
    row.time_s = frame->time_s;
    row.state = seen.state;
    row.true_state = truth.observation.state;
    row.depth_um = seen.indentation_um;
    row.true_depth_um = truth.observation.indentation_um;
    row.depth_sigma_um = seen.indentation_sigma_um;
    row.true_force_uN = truth.contact_force_uN;
    if (seen.needle && seen.outer) row.offset_um = needle_contact(seen).offset_um;
    row.is_measured = std::isfinite(estimate.contact_force_uN);
    if (row.is_measured) {
      row.force_uN = estimate.contact_force_uN;
      row.lower_uN = estimate.contact_force_lower_uN;
      row.upper_uN = estimate.contact_force_upper_uN;
      row.picture_lower_uN = estimate.by_picture.lower_uN;
      row.picture_upper_uN = estimate.by_picture.upper_uN;
      row.scale_ratio = estimate.errors.scale_ratio;
    }
    run.peak_uN = std::max(run.peak_uN, row.true_force_uN);
    run.frames.push_back(row);
    estimate.rest_um.resize(3, 0);
    estimate.solved_um.resize(3, 0);
    estimate.force_uN.resize(3, 0);
    run.estimates.push_back(std::move(estimate));
  }
  return run;
}

}  // namespace pellucida::test
