#include "pellucida/teaching/QuasiStaticCurve.h"

#include <string>

#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

constexpr double kCurveStep_um = 2.0;

}  // namespace

bool have_same_curve(const TeachingParameters& a, const TeachingParameters& b) {
  return a.profile == b.profile && a.mesh_frequency == b.mesh_frequency && a.young_modulus_kPa == b.young_modulus_kPa &&
         a.keeps_volume == b.keeps_volume;
}

expected<QuasiStaticCurvePtr, StepFailure> QuasiStaticStep::process(const TeachingParameters& parameters) {
  const CellProfile profile = profile_of(parameters);
  auto curve = std::make_shared<QuasiStaticCurve>();
  curve->parameters = parameters;
  Indenter indenter(profile, setup_of(profile, parameters));
  for (double depth_um = 0.0; depth_um <= deepest_um(profile) + 1e-9; depth_um += kCurveStep_um) {
    const IndentationState state = indenter.advance_to(depth_um);
    if (state.report.status != SolveStatus::kConverged) {
      // The curve ends where the equilibrium does.
      if (curve->depth_um.size() > 1) break;
      return unexpected<StepFailure>(StepFailure{"no equilibrium at " + std::to_string(depth_um) +
                                                 " um: " + std::string(to_string(state.report.status))});
    }
    curve->depth_um.push_back(depth_um);
    curve->force_uN.push_back(state.push_force_uN);
  }
  return QuasiStaticCurvePtr(std::move(curve));
}

}  // namespace pellucida
