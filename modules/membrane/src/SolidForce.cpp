#include "pellucida/membrane/SolidForce.h"

#include <algorithm>
#include <cmath>

#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

/// Cosines of the angle between the needle's way and the direction to the holder: from the first on the force is the
/// solid's (10 degrees), up to the second (25 degrees) not at all.
constexpr double kAll_cos = 0.985, kNothing_cos = 0.906;
/// So far from the profile's own geometry (`shape_distance`) the force is the solid's alone, nearer in proportion: its
/// polynomials leave 3 % everywhere, the springs' terms nothing there and 5.4 % at 0.5.
constexpr double kAllAway = 0.3;

}  // namespace

std::optional<SolidForce> SolidForce::of(const CellProfile& profile, const MembraneGeometry& geometry) {
  const double ratio = profile.geometry_range.solid_force_ratio;
  if (profile.geometry_terms.empty() || !(ratio > 0.0)) return std::nullopt;
  const double radius_um = geometry.mid_radius_um + 0.5 * geometry.thickness_um;
  const SolidParameters parameters(std::log(geometry.thickness_um / radius_um),
                                   std::log(geometry.tip_radius_um / radius_um),
                                   std::log(geometry.holder_radius_um / radius_um), 0.0, 0.0);
  if (IndentedSolid::shipped().within_range(parameters) != parameters) return std::nullopt;
  const double modulus_uN_per_um2 = 1e-3 * profile.effective_young_modulus_kPa;
  return SolidForce(parameters, radius_um, std::log(ratio * modulus_uN_per_um2 * radius_um * radius_um),
                    std::min(1.0, shape_distance(geometry, geometry_of(profile)) / kAllAway));
}

SolidForce::LogForce SolidForce::at(double depth_um) const {
  const IndentedSolid::Load load = solid_->load(parameters_, depth_um / radius_um_);
  return {log_scale_uN_ + load.log_force, load.by_depth / radius_um_};
}

double SolidForce::share(const MembraneSetup& setup) const noexcept {
  if (!setup.keeps_volume) return 0.0;
  const double opposite = (setup.push.dot(setup.holder) - kNothing_cos) / (kAll_cos - kNothing_cos);
  return away_ * std::clamp(opposite, 0.0, 1.0);
}

double solid_force_ratio(const CellProfile& profile) {
  CellProfile with_unit = profile, springs = profile;
  with_unit.geometry_range.solid_force_ratio = 1.0;
  springs.geometry_range.solid_force_ratio = 0.0;
  const MembraneGeometry own = geometry_of(profile);
  const auto solid = SolidForce::of(with_unit, own);
  if (!solid) return 0.0;
  const double depth_um = profile.puncture_indentation_um;
  const IndentationState state = force_curve(springs, 1, depth_um, depth_um).back();
  if (state.report.status != SolveStatus::kConverged || !(state.push_force_uN > 0.0)) return 0.0;
  return state.push_force_uN / std::exp(solid->at(depth_um).log_uN);
}

}  // namespace pellucida
