#pragma once
#include <memory>
#include <vector>

#include "pellucida/core/Step.h"
#include "pellucida/core_vtk/Scene.h"
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

struct SolvedShape;  // membrane/Indenter.h

/// A scene with its row and what the hand wants. What only views want is made from `estimate` (NodalForces.h).
struct MeasuredScene {
  Scene scene;
  ForceEstimate estimate;
};

/// The mechanics step of the chain: a scene with its observation in, the same scene with its forces out.
///
/// Fills of the measurement: contact_force_uN with its interval, lateral_force_uN, stiffness_uN_per_um, pressure_Pa,
/// shape_residual_um, asymmetry_um, model_spread_percent, puncture_probability, expected_puncture_uN and _um, and
/// volume_um3 where nothing has yet.
/// Fills `remarks`: why there is no force, why it should be doubted, the force according to other models.
/// Fills `contact`, the hand's model of the frame (ContactModelBuilder.h).
/// Events: `puncture` in the frame that shows it, with the largest force, depth and work (the state of that frame is
/// `punctured` then; a tracker's own event of it is left out, and one that the membrane does not bear out); `warning`
/// when the force becomes less certain, by name; `palpation` when the cell's scale has been learnt; `note` why there is
/// no force, and where a puncture that was reported is revoked.
/// A scene without a cell passes on without those parts. Where the model has no equilibrium, the force cells
/// of the measurement stay empty.
class MechanicsStep {
 public:
  using Input = Scene;
  using Output = MeasuredScene;

  explicit MechanicsStep(CellProfile profile);
  ~MechanicsStep();
  MechanicsStep(MechanicsStep&&) noexcept;
  MechanicsStep& operator=(MechanicsStep&&) noexcept;

  /// `known`: see `ForceObserver::process`. Fails for a scene without an observation.
  expected<MeasuredScene, StepFailure> process(const Scene& scene, const SolvedShape* known = nullptr);
  std::shared_ptr<const SolvedShape> solved_shape() const;

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
