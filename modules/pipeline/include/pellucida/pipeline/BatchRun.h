#pragma once
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core_vtk/FrameSource.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/pipeline/Distribution.h"
#include "pellucida/pipeline/PipelineOptions.h"

namespace pellucida {

struct BatchOptions {
  PipelineOptions pipeline;
  int job_count = 1;  ///< 1: one loop; more: tracking, mechanics, writing side by side
  std::function<void(long done, std::optional<long> all)> progress;  ///< after each frame; may be empty
};

/// Result of a batch.
struct BatchResult {
  std::vector<Measurement> rows;          ///< one per frame, in order
  std::map<CellState, long> state_count;  ///< frames by state
  std::optional<Scene> peak;              ///< the scene of the largest contact force, or of the best tracked frame
  std::map<std::string, Distribution> step_us;  ///< by step: tracking, mechanics, surface, writing
  Distribution frame_to_force_us;               ///< from a frame's arrival to its force
  CellProfile profile;                          ///< that the forces are scaled by
  CellScale cell_scale;                         ///< of the forces, relative to the profile's
  std::vector<PunctureRisk> puncture_risk;      ///< by depth; only with a scale of its own
  double elapsed_s = 0.0;
  long damaged_count = 0;          ///< frames that were not decoded as recorded: kept, not measured
  std::string first_damage;        ///< the first of them, with the reason; empty for none
  std::exception_ptr input_fault;  ///< why the input ended early; empty when it ended well
};

/// Measures every frame of `source` as far as its `use` says, as fast as possible, without loss; `sink` (may be empty)
/// receives each scene in order, on one thread. The numbers do not depend on `job_count`. An input that turns out
/// damaged is reported in `input_fault`; the frames before were measured. Throws what the sink throws, and UsageError
/// or InputError for a bad profile.
BatchResult run_batch(FrameSource& source, const BatchOptions& options, const std::function<void(const Scene&)>& sink);

/// What a summary says of damaged frames, with its line end; empty for none.
std::string damage_line(const BatchResult& result);

}  // namespace pellucida
