#pragma once
#include <vtkPolyDataAlgorithm.h>

#include "pellucida/reconstruction/Revolve.h"

namespace pellucida {

/// Revolves tracked contours about the symmetry axis into closed, outward-oriented surfaces.
///
/// Input port 0: vtkPolyData, one closed polyline a membrane, cell array `membrane`, field data `center_um`, `axis`,
/// `rest_radius_um` (see core_vtk/SceneData.h). Contours of the oolemma are ignored. Output port 0: vtkPolyData of
/// quads and triangles, outer membrane first; node order as in RevolvedMesh.
///
/// | output array    | on     | type, components | unit |                                                             |
/// |-----------------|--------|------------------|------|-------------------------------------------------------------|
/// | membrane        | points | int, 1           |      | 0 outer, 1 inner                                            |
/// | displacement_um | points | float, 3         | um   | node minus its place on the sphere at rest                  |
/// | rest_direction  | points | float, 3         | 1    | unit, from the cell centre to the node's place at rest      |
/// | volume_um3      | field  | double, 1 a surf.| um^3 | enclosed by each membrane, in the output's order, revolved  |
/// |                 |        |                  |      | smoothly: it does not depend on the angular step            |
///
/// Field data of the input is passed on. Where a rest radius is unknown (0), displacements count from the sphere of the
/// contour's own area. Fails (error code, message, empty output) when a contour can't be revolved or the field data is
/// missing; an input without cells gives an empty output and is not a failure. Cost: one pass over the contours and the
/// output's nodes.
class RevolveFilter : public vtkPolyDataAlgorithm {
 public:
  static RevolveFilter* New();
  vtkTypeMacro(RevolveFilter, vtkPolyDataAlgorithm);
  RevolveFilter(const RevolveFilter&) = delete;
  void operator=(const RevolveFilter&) = delete;

  /// Throws UsageError when an option is out of its range.
  void SetOptions(const RevolveOptions& options);
  const RevolveOptions& GetOptions() const { return options_; }

  /// Why the last update failed; empty when it did not.
  const std::string& GetFailure() const { return failure_; }

 protected:
  RevolveFilter() = default;
  ~RevolveFilter() override = default;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

 private:
  RevolveOptions options_;
  std::string failure_;
};

}  // namespace pellucida
