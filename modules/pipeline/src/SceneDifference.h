#pragma once
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics_vtk/NodalForces.h"
#include "pellucida/session/StepParts.h"

namespace pellucida {

/// Largest differences between two scenes of one frame; NaN where there was nothing to compare.
struct FieldDifferences {
  double contour_um = Measurement::kNotMeasured;
  double displacement_um = Measurement::kNotMeasured;
  double node_force_uN = Measurement::kNotMeasured;
};

/// What a frame's files hold that is the same under every profile. Any thread may read it.
struct CommonFields {
  Frozen<vtkPolyData> surface;  ///< narrowed, without the forces of a variant; empty: the frame has none
  bool has_recorded = false;    ///< the recorded surface has the same mesh
  FieldDifferences largest;     ///< of contours and displacement
  std::shared_ptr<const PackedPart> membranes, tools;
  std::shared_ptr<const PackedArrays> surface_arrays;
};

/// Adds to surface and contours what they were in the recording, and the difference:
///   | part      | points' array              | components | what |
///   | surface   | recorded_force_uN          | 3          | as recorded, where a force was |
///   | surface   | force_difference_uN        | 3          | now less recorded; a side without a force counts as 0 |
///   | surface   | recorded_displacement_um   | 3          | as recorded |
///   | surface   | displacement_difference_um | 3          | now less recorded |
///   | membranes | recorded_um                | 3          | nearest place of the recorded contour of that membrane |
///   | membranes | difference_um              | 1          | distance from it, positive outwards |
/// Nodes are compared by their number: surfaces of another mesh get no fields. A membrane that was not recorded gets
/// NaN. One thread at a time.
class CommonFieldsMaker {
 public:
  CommonFields make(const Scene& scene, const Scene& recorded);

 private:
  CommonPacker packer_;
};

/// The surface of one variant: the common one with its forces and their difference, narrowed; null where there is none.
/// Adds the largest difference of a force to `largest`.
vtkSmartPointer<vtkPolyData> variant_surface(const CommonFields& common, const SurfaceForces& forces,
                                             FieldDifferences& largest);

}  // namespace pellucida
