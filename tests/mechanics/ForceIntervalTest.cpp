#include "pellucida/mechanics/ForceInterval.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

CellProfile profile_with(double largest_ratio, double of_peak_ratio) {
  CellProfile profile;
  profile.puncture_force_uN = 7.5;
  profile.errors.push_back({1, "test", largest_ratio, of_peak_ratio, 4.0, 44.0});
  return profile;
}

TEST(ForceInterval, AbsoluteErrorsReachEquallyFarBothWays) {
  ForceErrors errors;
  errors.depth_uN = 0.3;
  errors.shape_uN = 0.4;
  const ForceInterval interval = interval_95(5.0, errors);
  EXPECT_NEAR(interval.upper_uN, 5.0 + 1.96 * 0.5, 1e-12);
  EXPECT_NEAR(interval.lower_uN, 5.0 - 1.96 * 0.5, 1e-12);
  EXPECT_NEAR(interval.sigma_uN, 0.5, 1e-12);
}

TEST(ForceInterval, RelativeErrorsMultiply) {
  ForceErrors errors;
  errors.scale_ratio = 0.2;
  const ForceInterval interval = interval_95(5.0, errors);
  EXPECT_NEAR(interval.upper_uN, 5.0 * std::exp(0.392), 1e-12);
  EXPECT_NEAR(interval.lower_uN, 5.0 * std::exp(-0.392), 1e-12);
}

TEST(ForceInterval, StiffeningCountsUpwardsOnly) {
  ForceErrors errors;
  errors.model_ratio = 0.05;
  const ForceInterval without = interval_95(5.0, errors);
  errors.stiffening_ratio = 0.12;
  const ForceInterval with = interval_95(5.0, errors);
  EXPECT_EQ(with.lower_uN, without.lower_uN);
  EXPECT_NEAR(with.upper_uN, 5.0 * std::exp(kSigmas95 * 0.13), 1e-12);
}

TEST(ForceInterval, PictureAndScaleMakeTheWhole) {
  ForceErrors errors;
  errors.depth_uN = 0.2;
  errors.shape_uN = 0.1;
  errors.relaxation_uN = 0.05;
  errors.model_uN = 0.04;
  errors.model_ratio = 0.05;
  errors.geometry_ratio = 0.1;
  errors.scale_ratio = 0.46;
  const ForceErrors picture = errors.of_picture(), scale = errors.of_scale();
  EXPECT_EQ(picture.scale_ratio, 0.0);
  EXPECT_EQ(scale.absolute_uN(), 0.0);
  EXPECT_EQ(scale.relative(), 0.46);
  EXPECT_NEAR(std::hypot(picture.relative(), scale.relative()), errors.relative(), 1e-12);
  EXPECT_EQ(picture.absolute_uN(), errors.absolute_uN());
  const ForceInterval whole = interval_95(5.0, errors);
  for (const ForceErrors& part : {picture, scale}) {
    const ForceInterval inner = interval_95(5.0, part);
    EXPECT_GT(inner.lower_uN, whole.lower_uN);
    EXPECT_LT(inner.upper_uN, whole.upper_uN);
  }
}

TEST(ForceInterval, IsNeverBelowNothingAndHoldsItsForce) {
  ForceErrors errors;
  errors.depth_uN = 1.0;
  errors.model_ratio = 0.1;
  for (const double force : {0.0, 0.1, 1.0, 10.0}) {
    const ForceInterval interval = interval_95(force, errors);
    EXPECT_GE(interval.lower_uN, 0.0);
    EXPECT_LE(interval.lower_uN, force);
    EXPECT_GT(interval.upper_uN, force);
  }
}

TEST(ForceInterval, ProfilesErrorIsTwoSigmaAndTheLesserOfItsTwoCounts) {
  ForceErrors middle, deep;
  add_model_errors(profile_with(0.2, 0.05), 1.5, 0.1, middle);
  EXPECT_NEAR(middle.model_ratio, -0.5 * std::log(0.8), 1e-12);
  // Far along, 5 % of the peak is less than 20 % of the force.
  add_model_errors(profile_with(0.2, 0.05), 6.0, 0.1, deep);
  EXPECT_NEAR(deep.model_ratio, 0.5 * 0.05 * 7.5 / 6.0, 1e-12);
}

TEST(ForceInterval, BelowTheDepthsComparedThereIsAnAbsoluteFloor) {
  ForceErrors shallow, touch;
  add_model_errors(profile_with(0.2, 0.5), 0.2, 0.1, shallow);
  add_model_errors(profile_with(0.2, 0.5), 0.01, 0.1, touch);
  EXPECT_EQ(shallow.model_ratio, 0.0);
  EXPECT_GT(shallow.model_uN, 0.0);
  EXPECT_EQ(shallow.model_uN, touch.model_uN);
  // As large as at the first depth compared: 4 um of 0.1 uN/um.
  EXPECT_NEAR(shallow.model_uN, -0.5 * std::log(0.8) * 0.4, 1e-12);
}

}  // namespace
}  // namespace pellucida
