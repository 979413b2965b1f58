#pragma once
#include <string>
#include <vector>

#include "pellucida/core/PaceFigures.h"
#include "pellucida/pipeline/PipelineOptions.h"

namespace pellucida {

/// How well a replay keeps its time, and how long other parameters take.
struct ReplayFigures {
  std::vector<PaceFigures> paces;  ///< at 0.5, 1 and 2 times the recorded speed
  int frame_count = 0;             ///< of the session measured again
  double recorded_s = 0.0;         ///< its length
  int variant_count = 0;           ///< moduli
  double counterfactual_s = 0.0;   ///< for all of them, sessions written
  int equal_row_count = 0;         ///< rows of a replay without changes that are the recorded ones
};

/// Plays `source` (a session; anything else is measured into one first) for `seconds` of wall time at each speed, and
/// measures all of it again with five moduli.
ReplayFigures measure_replay(const std::string& source, const PipelineOptions& pipeline, double seconds);

}  // namespace pellucida
