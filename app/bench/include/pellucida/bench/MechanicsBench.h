#pragma once
#include <vector>

#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What one camera frame costs the model.
struct SolveTimes {
  int node_count = 0;
  int spring_count = 0;
  std::vector<double> step_us;  ///< processor time of each warm frame: solution, tangent, read-out
  double factorizations_per_frame = 0.0;
  int failed_count = 0;  ///< frames that didn't converge
};

/// Pushes the needle to `to_um` and back, `step_um` a frame (12 um/s at 30 frames/s: 0.4 um), each frame a warm-started
/// solution, on the profile's cell in configuration 1, meshed with `mesh_frequency` (10 f^2 + 2 nodes). Only frames
/// past the first micrometre are timed.
SolveTimes measure_warm_solves(CellProfile profile, int mesh_frequency, double step_um = 0.4, double to_um = 30.0);

/// What one explicit time step costs.
struct ExplicitTimes {
  int node_count = 0;
  int spring_count = 0;
  double ns_per_spring_step = 0.0;        ///< ExplicitSprings
  double plain_ns_per_spring_step = 0.0;  ///< the same without AVX2
  double naive_ns_per_spring_step = 0.0;  ///< the same equations, one connector at a time in double precision
  double lane_use_ratio = 0.0;
};

/// Times eq. (4) on eq. (1), springs and dampers, for about `seconds` each, alternating; the quickest of the rounds
/// counts. The mesh is the profile's, with `mesh_frequency` (1..100).
ExplicitTimes measure_explicit_steps(CellProfile profile, int mesh_frequency, double seconds = 0.2);

}  // namespace pellucida
