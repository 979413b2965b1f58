// The aspirated shell against the half-space formula, and against itself at other sizes and meshes.
#include "pellucida/fem/AspirationReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// The suction over the modulus at a tongue longer by `grown_ratio` of the mouth than at rest.
double suction_at(const AspiratedShell& shell, double grown_ratio, double edge_length_ratio = 1.5) {
  AspirationReference reference(shell, edge_length_ratio);
  const double tongue_um = reference.rest_tongue_um() + grown_ratio * shell.mouth_radius_um;
  const AspirationCurve curve = reference.run(tongue_um);
  EXPECT_EQ(curve.outcome, CurveOutcome::kComplete);
  EXPECT_NEAR(curve.steps.back().tongue_um, tongue_um, 2e-4 * shell.mouth_radius_um);
  for (std::size_t k = 1; k < curve.steps.size(); ++k) {
    EXPECT_GT(curve.steps[k].suction_ratio, curve.steps[k - 1].suction_ratio);
    EXPECT_GT(curve.steps[k].tongue_um, curve.steps[k - 1].tongue_um);
  }
  return curve.steps.back().suction_ratio;
}

// Theret's punch model has Phi between 2.0 and 2.1 for walls of the mouth's own radius down to a fifth of it.
TEST(AspirationReference, AThickShellOnANarrowMouthIsAHalfSpace) {
  for (const double lip_um : {1.0, 4.0}) {
    const AspiratedShell thick{
        .outer_radius_um = 52.5, .thickness_um = 25.0, .mouth_radius_um = 4.0, .lip_width_um = lip_um};
    const double ratio = suction_at(thick, 0.06) / half_space_suction_ratio(0.06 * 4.0, 4.0);
    std::printf("h 25, mouth 4, lip %.0f um: suction %.3f of the half-space formula's\n", lip_um, ratio);
    EXPECT_NEAR(ratio, 1.03, 0.08);
  }
}

TEST(AspirationReference, AZonaIsFarSofterThanAHalfSpace) {
  const AspiratedShell zona{};
  const double ratio = suction_at(zona, 0.4) / half_space_suction_ratio(0.4 * 10.0, 10.0);
  std::printf("zona of 5 um, mouth 10 um, tongue grown by 0.4: suction %.3f of the half-space formula's\n", ratio);
  EXPECT_NEAR(ratio, 0.32, 0.03);
  // Thicker: stiffer, by a power between a membrane's and a plate's.
  AspiratedShell thick = zona;
  thick.thickness_um = 6.0;
  const double power = std::log(suction_at(thick, 0.4) / suction_at(zona, 0.4)) / std::log(1.2);
  std::printf("suction goes with thickness to the power %.2f\n", power);
  EXPECT_GT(power, 0.8);
  EXPECT_LT(power, 2.5);
}

TEST(AspirationReference, OnlyRatiosOfLengthsCountAndTheMeshHardly) {
  const AspiratedShell shell{};
  const AspiratedShell twice{105.0, 10.0, 20.0, 10.0};
  const double suction = suction_at(shell, 0.4);
  EXPECT_NEAR(suction_at(twice, 0.4), suction, 0.002 * suction);
  EXPECT_NEAR(suction_at(shell, 0.4, 1.0), suction, 0.03 * suction);
}

TEST(AspirationReference, NonsenseIsRefused) {
  EXPECT_THROW(AspirationReference({.thickness_um = 0.0}), UsageError);
  EXPECT_THROW(AspirationReference({.mouth_radius_um = 50.0}), UsageError);
  EXPECT_THROW(AspirationReference({.outer_radius_um = std::nan("")}), UsageError);
  EXPECT_THROW(AspirationReference({}, 10.0), UsageError);
  AspirationReference reference{{}};
  EXPECT_THROW(reference.run(0.5 * reference.rest_tongue_um()), UsageError);
}

}  // namespace
}  // namespace pellucida
