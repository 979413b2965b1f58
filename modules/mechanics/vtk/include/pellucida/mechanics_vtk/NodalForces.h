#pragma once
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>

#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics/ForceEstimate.h"

namespace pellucida {

/// The point arrays that the mechanics adds to a surface; null where there is no force.
struct SurfaceForces {
  vtkSmartPointer<vtkDataArray> force_uN, force_sigma_uN, needle_force_uN, holder_force_uN, tension_uN_per_um,
      tension_sigma_uN_per_um, area_strain_percent;

  /// All of them.
  std::array<vtkDataArray*, 7> arrays() const {
    return {force_uN,          force_sigma_uN,          needle_force_uN,    holder_force_uN,
            tension_uN_per_um, tension_sigma_uN_per_um, area_strain_percent};
  }
};

/// From the solved model to what views draw. It comes after the row and the hand's model, so that neither waits for a
/// picture.
///
/// Makes `model`: triangles in the solved shape, frame W, with point arrays
///   | array              | components | unit   | what                                                     |
///   | force_uN           | 3          | uN     | the membrane's own elastic force on the node             |
///   | displacement_um    | 3          | um     | from rest                                                |
///   | tension_uN_per_um  | 1          | uN/um  | mean membrane tension                                    |
///   | area_strain_percent| 1          | %      | area of the triangles round the node against rest        |
/// Adds to a copy of `surface`, which must bring point arrays `membrane` and `rest_direction`:
///   force_uN (3), force_sigma_uN (1), needle_force_uN (3), holder_force_uN (3), tension_uN_per_um (1),
///   tension_sigma_uN_per_um (1), area_strain_percent (1). The model's one surface represents the whole zona: its
///   forces are shown on the outer membrane, with their sum kept; nodes of the inner one carry no force of their own
///   (0). Tension and strain are the zona's, so both membranes show them.
/// A scene without surface, or whose estimate has no equilibrium, passes on without those parts. One thread at a time.
class NodalForces {
 public:
  NodalForces();
  ~NodalForces();
  NodalForces(NodalForces&&) noexcept;
  NodalForces& operator=(NodalForces&&) noexcept;

  /// The scene with model and forces. `estimate`: of this scene's observation.
  Scene add_to(Scene scene, const ForceEstimate& estimate);
  /// The arrays alone, for a surface that is written and never shown.
  SurfaceForces forces_on(const Frozen<vtkPolyData>& surface, const ForceEstimate& estimate);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
