#include "ErrorBudget.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// A needle whose line moved by more than this since the contact began has slipped.
constexpr double kSlip_um = 4.0;
/// What a contour may differ from the model by, um, beside its noise: at rest, and more for each um of depth (the
/// virtual microscope's cells; see the module's README).
constexpr double kUsualMismatch_um = 0.2;
constexpr double kUsualMismatch_ratio = 0.02;
/// Beyond so many times what is usual the shape isn't the model's.
constexpr double kMismatch = 2.5;
/// A force at which all but this share of the profile's cells of these sizes would be punctured is seldom borne.
constexpr double kSeldomBorne_ratio = 0.2;
/// Half of the spread of the force between needle opposite the holder and beside it, where no holder was seen.
constexpr double kUnknownHolder_ratio = 0.3;
/// What walls out of round or sucked differ from the model by at the same modulus, and how much more those bear that
/// stiffen with strain where no contours show it; of the logarithm (docs/method.md, 4.4).
constexpr double kUnlikeWall_ratio = 0.03, kStiffening_ratio = 0.13;
/// A push of known force takes the sizes' error with it. This share of it is taken as left at other depths where the
/// solid does not say: 0.30 is, of thickness, tip and holder wrong by their standard deviations, at 10 to 44 um after a
/// push at 5 um.
constexpr double kGeometryLeft_ratio = 0.4;

}  // namespace

double usual_mismatch_um(const ShapeAudit& shape, double depth_um) {
  return std::hypot(shape.noise_um, kUsualMismatch_um + kUsualMismatch_ratio * depth_um);
}

void fill_errors(const BudgetInput& in, ForceEstimate& estimate) {
  ForceErrors& errors = estimate.errors;
  const double stiffness_uN_per_um = in.force.stiffness_uN_per_um;
  errors.depth_uN = stiffness_uN_per_um * estimate.depth_sigma_um;
  errors.relaxation_uN = in.force.sigma_uN;
  errors.scale_ratio = in.scale.relative_sigma;
  errors.geometry_ratio = (in.scale.has_geometry && !in.sizes.log_sigma ? kGeometryLeft_ratio : 1.0) *
                          std::hypot(in.cell.geometry().force_sigma_ratio(in.sizes.log_sigma),
                                     estimate.holder_assumed ? kUnknownHolder_ratio : 0.0);
  add_model_errors(in.profile, in.model_force_uN, in.cell.rest_stiffness_uN_per_um(), errors);
  errors.model_ratio =
      std::hypot(std::hypot(errors.model_ratio, kUnlikeWall_ratio),
                 std::hypot(in.sizes.stiffening_log_sigma.value_or(0.0), in.sizes.elongation_log_sigma));
  errors.stiffening_ratio = in.sizes.stiffening_log_sigma ? 0.0 : kStiffening_ratio;
  errors.model_uN *= in.scale.ratio * in.force.ratio;

  // The contour beside the model: beyond what is usual it counts as a depth that isn't known.
  const ShapeAudit& shape = estimate.shape;
  unsigned warnings = kNoForceWarning;
  if (std::isfinite(shape.residual_rms_um)) {
    const double usual_um = usual_mismatch_um(shape, in.depth_um);
    const double beyond_um = std::max(0.0, shape.residual_rms_um - usual_um);
    errors.shape_uN = stiffness_uN_per_um * beyond_um;
    if (shape.residual_rms_um > kMismatch * usual_um) warnings |= kShapeMismatch;
    estimate.asymmetry_force_uN = stiffness_uN_per_um * shape.unexplained_asymmetry_um;
    if (shape.unexplained_asymmetry_um > kMismatch * usual_um) warnings |= kNotOfRevolution;
  }
  if (estimate.puncture_doubted || std::abs(in.placement.slipped_um()) > kSlip_um) warnings |= kNeedleSlip;
  // In forces of the kind: how single cells differ is in the spread of their punctures already.
  const ExpectedPuncture expected = expected_puncture(in.profile, in.cell.built_geometry());
  const double punctured = puncture_probability(expected, in.force.force_uN, errors.of_picture().relative());
  if (punctured > 1.0 - kSeldomBorne_ratio) warnings |= kSeldomBorne;
  estimate.warnings = static_cast<ForceWarning>(warnings);
}

}  // namespace pellucida
