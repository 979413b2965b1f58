#include "pellucida/identification/ForceScale.h"

#include <cmath>
#include <string>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

/// The model's forces at rising depths, configuration 1.
Eigen::VectorXd model_forces_uN(const CellProfile& profile, const Eigen::VectorXd& depths_um) {
  const double deepest_um = depths_um[depths_um.size() - 1];
  if (deepest_um > 1.4 * profile.mid_radius_um) {
    throw UsageError("force scale: an indentation of " + std::to_string(deepest_um) +
                     " um is beyond 1.4 radii of the cell; check the unit, or give the cell's radius");
  }
  const MembraneSetup setup = setup_for_configuration(profile, 1);
  Indenter indenter(profile, geometry_of(profile), setup.push, setup.holder);
  Eigen::VectorXd forces(depths_um.size());
  for (Eigen::Index k = 0; k < depths_um.size(); ++k) {
    const IndentationState state = indenter.advance_to(depths_um[k]);
    if (state.report.status != SolveStatus::kConverged) {
      throw UsageError("force scale: the model finds no equilibrium beyond " + std::to_string(state.depth_um) +
                       " um; measure the scale at a smaller depth");
    }
    forces[k] = state.push_force_uN;
  }
  return forces;
}

}  // namespace

ForceScale scale_to_point(const CellProfile& profile, double force_uN, double indentation_um,
                          double assumed_relative_sigma) {
  if (!(force_uN > 0.0) || !(indentation_um > 0.0)) {
    throw UsageError("force scale: puncture force and indentation must be above 0");
  }
  const Eigen::VectorXd model_uN = model_forces_uN(profile, Eigen::VectorXd::Constant(1, indentation_um));
  return {force_uN / model_uN[0], assumed_relative_sigma, 0.0, 1};
}

ForceScale scale_to_curve(const CellProfile& profile, const MeasuredCurve& measured) {
  const Eigen::VectorXd model_uN = model_forces_uN(profile, measured.indentation_um);
  const double square_sum = model_uN.squaredNorm();
  ForceScale scale;
  scale.point_count = static_cast<int>(model_uN.size());
  scale.ratio = square_sum > 0.0 ? measured.force_uN.dot(model_uN) / square_sum : 0.0;
  if (!(scale.ratio > 0.0)) {
    throw NothingMeasuredError("force scale: the measured forces don't rise with the indentation; check their sign");
  }
  const double residual = (measured.force_uN - scale.ratio * model_uN).squaredNorm();
  scale.residual_rms_uN = std::sqrt(residual / scale.point_count);
  scale.relative_sigma = std::sqrt(residual / (scale.point_count - 1) / square_sum) / scale.ratio;
  return scale;
}

void apply(const ForceScale& scale, CellProfile& profile) {
  profile.effective_young_modulus_kPa *= scale.ratio;
  profile.force_scale_relative_sigma = scale.relative_sigma;
}

}  // namespace pellucida
