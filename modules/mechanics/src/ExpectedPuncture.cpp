#include "pellucida/mechanics/ExpectedPuncture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ForcePowers.h"

namespace pellucida {
namespace {

/// Of the logarithm of the section's ratio: what is not known of the power with which a puncture goes with it.
constexpr double kUnknownPower = 0.5;
/// How the depth's power falls towards the surface: set on the specimens 1001 to 1027 of tests/specimens.
constexpr double kFlattening = 0.2;
/// No deeper than the model reaches, in radii.
constexpr double kDeepest_ratio = 1.4;

}  // namespace

ExpectedPuncture expected_puncture(const CellProfile& profile, const MembraneGeometry& geometry,
                                   double scale_ratio) noexcept {
  const MembraneGeometry own = geometry_of(profile);
  const auto log_of = [&](double MembraneGeometry::*length) { return std::log(geometry.*length / (own.*length)); };
  const double thickness = log_of(&MembraneGeometry::thickness_um), tip = log_of(&MembraneGeometry::tip_radius_um);
  const double section = thickness + tip;
  const double stiffer = std::log(scale_ratio) + kThicknessPower * thickness + kTipPower * tip +
                         kHolderPower * log_of(&MembraneGeometry::holder_radius_um) -
                         kRadiusPower * log_of(&MembraneGeometry::mid_radius_um);
  ExpectedPuncture expected;
  expected.force_uN = profile.puncture_force_uN * std::exp(section);
  expected.sigma_ratio = std::hypot(kPunctureSpread_ratio, kUnknownPower * section);
  // Shallower than the kind's puncture the force goes with a lower power of the depth.
  const double log_force = section - stiffer, shallower = std::min(0.0, log_force);
  const double log_depth = log_force / kDepthPower - kFlattening * shallower * shallower;
  expected.depth_um =
      std::min(profile.puncture_indentation_um * std::exp(log_depth), kDeepest_ratio * geometry.mid_radius_um);
  return expected;
}

double puncture_probability(const ExpectedPuncture& expected, double force_uN, double force_relative_sigma) noexcept {
  if (!(force_uN > 0.0) || !(expected.force_uN > 0.0)) return 0.0;
  const double sigma = std::hypot(force_relative_sigma, expected.sigma_ratio);
  return 0.5 * std::erfc(-std::log(force_uN / expected.force_uN) / sigma / std::numbers::sqrt2);
}

}  // namespace pellucida
