#include "pellucida/identification/Aspiration.h"

#include <cmath>
#include <string>

#include "ProfileSpecimen.h"
#include "pellucida/core/Error.h"
#include "pellucida/fem/AspirationReference.h"
#include "pellucida/fem/SolidReference.h"

namespace pellucida {
namespace {

/// Coarser elements than the reference's own: 2 % of the suction, twice as fast.
constexpr double kAspirationEdge_ratio = 1.5;
/// What elements, law and the bonded lip leave open, of ln E.
constexpr double kElements_ratio = 0.05;
/// The zona's thickness where it is not given, of its value.
constexpr double kUnseenThickness_ratio = 0.25;
/// The lip's width over the mouth's radius: 0.2 to 1 changes the suction by 10 %.
constexpr double kLipWidth_ratio = 0.5;
/// A change of the thickness by this share gives the slope.
constexpr double kThicknessProbe_ratio = 0.1;
/// Of the solid under the needle, steps to the puncture.
constexpr double kSolidStep_um = 2.0;

/// The suction over the modulus at a tongue, and its slope, from the curve's last steps.
struct Drawn {
  double ratio = 0.0;
  double log_slope_per_um = 0.0;  ///< d ln ratio / d tongue
};

Drawn drawn_to(const AspiratedShell& shell, double tongue_um) {
  AspirationReference reference(shell, kAspirationEdge_ratio);
  const AspirationCurve curve = reference.run(tongue_um);
  const AspirationStep& last = curve.steps.back();
  if (curve.outcome != CurveOutcome::kComplete || last.tongue_um < tongue_um - 1e-3 * shell.mouth_radius_um) {
    throw UsageError("aspiration: no zona of this thickness forms a tongue of " + std::to_string(tongue_um) +
                     " um in that mouth; check length, radius and thickness");
  }
  // A step of some tenths of the mouth's radius before the end.
  std::size_t k = curve.steps.size() - 1;
  while (k > 1 && last.tongue_um - curve.steps[k].tongue_um < 0.05 * shell.mouth_radius_um) --k;
  const AspirationStep& before = curve.steps[k];
  Drawn drawn{last.suction_ratio, 0.0};
  if (before.suction_ratio > 0.0 && last.tongue_um > before.tongue_um) {
    drawn.log_slope_per_um = std::log(last.suction_ratio / before.suction_ratio) / (last.tongue_um - before.tongue_um);
  } else {
    drawn.log_slope_per_um = 1.0 / (last.tongue_um - reference.rest_tongue_um());
  }
  return drawn;
}

/// The modulus of a solid that passes the profile's puncture point, over the effective one.
double solid_over_effective(const CellProfile& profile) {
  SolidReference solid(specimen_of(profile), contact_of(profile));
  const SolidCurve curve = solid.run(profile.puncture_indentation_um, kSolidStep_um);
  if (curve.outcome != CurveOutcome::kComplete) {
    throw UsageError(
        "aspiration: finite elements find no solid zona at the profile's puncture point; measure the scale "
        "by a push instead");
  }
  return profile.puncture_force_uN / curve.steps.back().force_uN;
}

}  // namespace

AspiratedModulus aspirated_modulus(const ScaleMeasurement& aspiration, const CellProfile& profile) {
  if (way_of(aspiration) != ScaleWay::kAspiration)
    throw UsageError("aspiration: suction, tongue and mouth are missing");
  const bool thickness_given = aspiration.zona_thickness_um > 0.0;
  const double thickness_um = thickness_given ? aspiration.zona_thickness_um : profile.thickness_um;
  const double thickness_sigma_um =
      thickness_given ? aspiration.zona_thickness_sigma_um : kUnseenThickness_ratio * profile.thickness_um;
  AspiratedShell shell;
  shell.thickness_um = thickness_um;
  shell.outer_radius_um = profile.mid_radius_um + 0.5 * thickness_um;
  shell.mouth_radius_um = aspiration.mouth_radius_um;
  shell.lip_width_um = kLipWidth_ratio * aspiration.mouth_radius_um;
  const Drawn at = drawn_to(shell, aspiration.tongue_um);
  AspiratedShell thicker = shell;
  thicker.thickness_um *= 1.0 + kThicknessProbe_ratio;
  const double by_thickness =
      std::log(drawn_to(thicker, aspiration.tongue_um).ratio / at.ratio) / std::log1p(kThicknessProbe_ratio);
  // The ratio depends on ratios of lengths alone, and little on the cell's radius: what tongue and thickness leave of
  // ln(length) is the mouth's.
  const double by_tongue = at.log_slope_per_um * aspiration.tongue_um;
  const double by_mouth = -by_tongue - by_thickness;

  AspiratedModulus result;
  result.modulus_kPa = aspiration.suction_kPa / at.ratio;
  const double tongue = by_tongue * aspiration.tongue_sigma_um / aspiration.tongue_um;
  const double mouth = by_mouth * aspiration.mouth_radius_sigma_um / aspiration.mouth_radius_um;
  const double thickness = by_thickness * thickness_sigma_um / thickness_um;
  result.relative_sigma = std::hypot(std::hypot(0.01 * aspiration.suction_sigma_percent, tongue),
                                     std::hypot(mouth, thickness), kElements_ratio);
  const double grown_um =
      aspiration.tongue_um - (shell.outer_radius_um - std::sqrt(shell.outer_radius_um * shell.outer_radius_um -
                                                                shell.mouth_radius_um * shell.mouth_radius_um));
  result.half_space_modulus_kPa = aspiration.suction_kPa / half_space_suction_ratio(grown_um, shell.mouth_radius_um);
  return result;
}

ScaleMeasurement with_modulus(const ScaleMeasurement& measurement, const CellProfile& profile) {
  ScaleMeasurement filled = measurement;
  if (way_of(measurement) != ScaleWay::kAspiration || measurement.modulus_kPa > 0.0) return filled;
  const AspiratedModulus modulus = aspirated_modulus(measurement, profile);
  filled.modulus_kPa = modulus.modulus_kPa;
  filled.modulus_sigma_percent = 100.0 * modulus.relative_sigma;
  filled.modulus_of_profile_ratio = solid_over_effective(profile);
  return filled;
}

}  // namespace pellucida
