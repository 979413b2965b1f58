#pragma once
#include <cstddef>
#include <vector>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/pipeline/LiveRun.h"

namespace pellucida {

/// What one tick of the window shows: the newest measured scene and the rows up to it, nothing newer. Views, readouts
/// and charts are all fed by it, so they show one and the same number. Until a scene was measured, the newest frame as
/// it came. One thread.
class SceneFeed {
 public:
  /// Both must outlive it; `source` feeds the views.
  SceneFeed(const LiveRun& run, StageSource* source);

  /// Takes over what is newest; true when the source hands out another scene than before.
  bool poll();

  /// The scene shown, once one was measured; nullptr before.
  const Scene* measured() const;
  /// Rows that the last `poll` added, in order, the scene's own last.
  const std::vector<Measurement>& new_rows() const noexcept { return new_rows_; }

 private:
  const LiveRun& run_;
  StageSource* source_;
  std::vector<Measurement> new_rows_;
  std::size_t row_count_ = 0;
  bool is_measured_ = false;
  long frame_ = -1;  // shown before a scene was measured
};

}  // namespace pellucida
