#pragma once
#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <vector>

#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

struct SolvedShape;  // membrane/Indenter.h

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

/// A measured scene without what only views and the hand want.
struct MeasuredScene {
  Scene scene;  ///< its surface is the input's, its model empty
  SurfaceForces forces;
};

/// The mechanics step of the chain: a scene with observation and surface in, the same scene with forces out.
///
/// Fills of the measurement: contact_force_uN with its interval, lateral_force_uN, stiffness_uN_per_um, pressure_Pa,
/// shape_residual_um, asymmetry_um, model_spread_percent, puncture_probability, expected_puncture_uN and _um, and
/// volume_um3 where nothing has yet.
/// Fills `remarks`: why there is no force, why it should be doubted, the force according to other models.
/// Fills `contact`, the hand's model of the frame (ContactModelBuilder.h).
/// Events: `puncture` in the frame that shows it, with the largest force, depth and work (the state of that frame is
/// `punctured` then; a tracker's own event of it is left out, and one that the membrane does not bear out); `warning`
/// when the force becomes less certain, by name; `palpation` when the cell's scale has been learnt; `note` why there is
/// no force, and where a puncture that was reported is revoked. Makes `model`: triangles in the solved shape, frame W,
/// with point arrays
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
/// A scene without cell or surface passes on without those parts. Where the model has no equilibrium, the force cells
/// of the measurement stay empty.
class MechanicsStep {
 public:
  using Input = Scene;
  using Output = Scene;

  explicit MechanicsStep(CellProfile profile);
  ~MechanicsStep();
  MechanicsStep(MechanicsStep&&) noexcept;
  MechanicsStep& operator=(MechanicsStep&&) noexcept;

  /// `known`: see `ForceObserver::process`.
  expected<Scene, StepFailure> process(const Scene& scene, const SolvedShape* known = nullptr);
  std::shared_ptr<const SolvedShape> solved_shape() const;
  /// The same for a scene that is written and never shown: the same numbers, `model` left out and the forces beside the
  /// surface.
  expected<MeasuredScene, StepFailure> measure(const Scene& scene, const SolvedShape* known = nullptr);

  /// See `ForceObserver`; from the next call of `process` on. From any thread. Throws likewise.
  void set_scale_measurements(std::vector<ScaleMeasurement> measurements);
  /// See `ForceObserver`. Between two calls of `process`.
  CellScale scale() const noexcept;
  std::vector<PunctureRisk> puncture_risk(double step_um);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
