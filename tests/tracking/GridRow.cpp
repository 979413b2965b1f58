#include "tracking/GridRow.h"

#include <algorithm>
#include <chrono>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida::test {

Spread spread_of(std::vector<double> values) {
  Spread spread;
  const auto end = std::remove_if(values.begin(), values.end(), [](double v) { return v < 0.0; });
  spread.missing = static_cast<int>(values.end() - end);
  values.erase(end, values.end());
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  const auto at = [&](double part) { return values[static_cast<std::size_t>(part * (values.size() - 1) + 0.5)]; };
  spread.median = at(0.5);
  spread.p95 = at(0.95);
  spread.largest = values.back();
  return spread;
}

GridRun run_condition(const GridCondition& condition) {
  using Clock = std::chrono::steady_clock;
  GridRun run;
  MembraneTracker tracker;
  VirtualMicroscope microscope(condition.scenario);
  while (const std::optional<Frame> frame = microscope.next()) {
    const auto start = Clock::now();
    const Observation seen = tracker.process(view_of(frame->image.get()), frame->time_s, frame->frame_index);
    run.frame_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    run.errors.push_back(compare(seen, microscope.truth().observation, condition.scenario.image.pixel_size_um));
    for (int skipped = 1; skipped < condition.stride; ++skipped) microscope.skip();
  }
  return run;
}

GridRow summarize_run(const std::string& name, const GridRun& run) {
  GridRow row;
  row.name = name;
  row.frames = static_cast<int>(run.errors.size());
  const auto values = [&](double FrameError::*member) {
    std::vector<double> all;
    for (const FrameError& e : run.errors) all.push_back(e.*member);
    return all;
  };
  row.outer_px = spread_of(values(&FrameError::outer_px));
  row.inner_px = spread_of(values(&FrameError::inner_px));
  row.tip_px = spread_of(values(&FrameError::tip_px));
  row.indentation_rms_um = summarize_indentation(run.errors).rms;
  for (const FrameError& e : run.errors) {
    row.outer_coverage += e.outer_coverage;
    row.inner_coverage += e.inner_coverage;
    row.dimple_coverage += e.dimple_coverage;
    row.tip_coverage += e.tip_coverage;
    row.depth_coverage += e.depth_coverage;
    const bool lost = e.state == CellState::kLost || e.state == CellState::kNoCell;
    row.confident_and_wrong += e.confident_and_wrong() ? 1 : 0;
    row.lost += lost ? 1 : 0;
    row.wrong_states += !lost && e.state != e.true_state ? 1 : 0;
  }
  row.median_frame_ms = spread_of(run.frame_ms).median;
  return row;
}

}  // namespace pellucida::test
