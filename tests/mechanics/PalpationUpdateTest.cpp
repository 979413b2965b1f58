#include "pellucida/membrane/PalpationUpdate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/mechanics/ExpectedPuncture.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

TEST(PalpationUpdate, IsTheWeightedMeanOfTheLogarithms) {
  const Palpation palpation{
      .known_force_uN = 0.9, .indentation_um = 5.0, .indentation_sigma_um = 0.0, .relative_sigma = 0.4};
  const CellScale after = update_scale({1.0, 0.4}, palpation, 0.6, 0.1, 0.0);
  EXPECT_NEAR(after.ratio, std::sqrt(1.5), 1e-12);
  EXPECT_NEAR(after.relative_sigma, 0.4 / std::sqrt(2.0), 1e-12);
}

TEST(PalpationUpdate, ASharpPalpationRulesAndABluntOneHardlyCounts) {
  Palpation palpation{
      .known_force_uN = 1.2, .indentation_um = 5.0, .indentation_sigma_um = 0.0, .relative_sigma = 0.01};
  EXPECT_NEAR(update_scale({1.0, 0.46}, palpation, 0.6, 0.1, 0.0).ratio, 2.0, 0.0013);
  palpation.relative_sigma = 10.0;
  const CellScale blunt = update_scale({1.0, 0.46}, palpation, 0.6, 0.1, 0.0);
  EXPECT_NEAR(blunt.ratio, 1.0, 0.003);
  EXPECT_NEAR(blunt.relative_sigma, 0.46, 0.001);
}

TEST(PalpationUpdate, AnUnsureDepthMakesItBlunter) {
  Palpation palpation{
      .known_force_uN = 1.2, .indentation_um = 5.0, .indentation_sigma_um = 0.0, .relative_sigma = 0.05};
  const CellScale sharp = update_scale({1.0, 0.46}, palpation, 0.6, 0.1, 0.0);
  palpation.indentation_sigma_um = 1.0;
  const CellScale unsure = update_scale({1.0, 0.46}, palpation, 0.6, 0.1, 0.0);
  EXPECT_GT(unsure.relative_sigma, 2.0 * sharp.relative_sigma);
  EXPECT_LT(unsure.ratio, sharp.ratio);
}

TEST(PalpationUpdate, ProbabilityIsHalfAtTheProfilesPunctureForceAndRises) {
  const CellProfile profile = testing::coarse_profile();
  const ExpectedPuncture expected = expected_puncture(profile, geometry_of(profile));
  EXPECT_EQ(expected.depth_um, profile.puncture_indentation_um);
  EXPECT_NEAR(puncture_probability(expected, profile.puncture_force_uN, 0.1), 0.5, 1e-12);
  EXPECT_EQ(puncture_probability(expected, 0.0, 0.1), 0.0);
  double before = 0.0;
  for (double force = 1.0; force < 30.0; force += 1.0) {
    const double now = puncture_probability(expected, force, 0.1);
    EXPECT_GT(now, before);
    EXPECT_LT(now, 1.0);
    before = now;
  }
  // A standard deviation up, with the force known exactly.
  EXPECT_NEAR(puncture_probability(expected, profile.puncture_force_uN * std::exp(kPunctureSpread_ratio), 0.0), 0.8413,
              9e-5);
}

// A finer needle is through earlier, and a blunter one or a thicker wall later; how much is less sure then.
TEST(PalpationUpdate, AnotherNeedleOrZonaMovesThePuncture) {
  const CellProfile profile = testing::coarse_profile();
  const ExpectedPuncture usual = expected_puncture(profile, geometry_of(profile));
  EXPECT_EQ(usual.sigma_ratio, kPunctureSpread_ratio);
  MembraneGeometry fine = geometry_of(profile), thick = fine;
  fine.tip_radius_um *= 0.5;
  thick.thickness_um *= 2.0;
  const ExpectedPuncture with_fine = expected_puncture(profile, fine), of_thick = expected_puncture(profile, thick);
  EXPECT_NEAR(with_fine.force_uN, 0.5 * usual.force_uN, 1e-12);
  EXPECT_LT(with_fine.depth_um, usual.depth_um);
  EXPECT_NEAR(of_thick.force_uN, 2.0 * usual.force_uN, 1e-12);
  EXPECT_GT(with_fine.sigma_ratio, usual.sigma_ratio);
  // A stiffer cell bears the same force, at a smaller depth.
  const ExpectedPuncture stiff = expected_puncture(profile, geometry_of(profile), 2.0);
  EXPECT_EQ(stiff.force_uN, usual.force_uN);
  EXPECT_LT(stiff.depth_um, 0.75 * usual.depth_um);
}

TEST(PalpationUpdate, NonsenseIsRefused) {
  EXPECT_THROW(validate({.known_force_uN = 0.0, .indentation_um = 5.0}), UsageError);
  EXPECT_THROW(validate({.known_force_uN = 1.0, .known_stiffness_uN_per_um = 1.0, .indentation_um = 5.0}), UsageError);
  EXPECT_THROW(validate({.known_force_uN = 1.0, .indentation_um = 0.0}), UsageError);
  EXPECT_THROW(validate({.known_force_uN = 1.0, .indentation_um = 5.0, .relative_sigma = 0.0}), UsageError);
  EXPECT_THROW(validate({.known_force_uN = std::nan(""), .indentation_um = 5.0}), UsageError);
  EXPECT_NO_THROW(validate({.known_stiffness_uN_per_um = 0.1, .indentation_um = 5.0}));
}

}  // namespace
}  // namespace pellucida
