#pragma once
#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// Largest differences between two scenes of one frame; NaN where there was nothing to compare.
struct FieldDifferences {
  double contour_um = Measurement::kNotMeasured;
  double displacement_um = Measurement::kNotMeasured;
  double node_force_uN = Measurement::kNotMeasured;
};

/// Adds to the surface and the contours of `scene` what they were in `recorded`, and the difference:
///   | part      | points' array              | components | what | | surface   | recorded_force_uN          | 3 | as
///   recorded, where a force was                              | | surface   | force_difference_uN        | 3          |
///   scene less recorded; a side without a force counts as 0     | | surface   | recorded_displacement_um   | 3 | as
///   recorded                                                 | | surface   | displacement_difference_um | 3          |
///   scene less recorded                                         | | membranes | recorded_um                | 3 |
///   nearest place of the recorded contour of the same membrane  | | membranes | difference_um              | 1 |
///   distance from it, positive outwards                         |
/// Nodes are compared by their number: surfaces of another mesh get no fields. A membrane that was not recorded gets
/// NaN.
FieldDifferences add_differences(Scene& scene, const Scene& recorded);

}  // namespace pellucida
