#include "pellucida/mechanics/ForceCrossCheck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

TEST(ForceCrossCheck, PointLoadFormulaGoesWithTheCubeOfTheDepth) {
  // With a zona of 4.8 um, a tip of 4 um and a dimple of 40 um it meets the oocyte's puncture point.
  const auto force = point_load_force_uN(17.9, 0.5, 4.8, 44.0, 40.0, 4.0);
  ASSERT_TRUE(force);
  EXPECT_NEAR(*force, 7.5, 0.3);
  EXPECT_NEAR(*point_load_force_uN(17.9, 0.5, 4.8, 22.0, 40.0, 4.0), *force / 8.0, 1e-9);
  EXPECT_FALSE(point_load_force_uN(17.9, 0.5, 4.8, 44.0, 3.0, 4.0));
  EXPECT_FALSE(point_load_force_uN(17.9, 0.5, 4.8, 0.0, 40.0, 4.0));
}

TEST(ForceCrossCheck, TablesHoldThePuncturePointAndBlendBetweenHolders) {
  const ForceTables tables("mouse-oocyte");
  const double quarter = 0.25 * std::numbers::pi;
  EXPECT_NEAR(tables.force_uN(44.0, 0.0).value(), 7.5, 1e-9);
  const double one = tables.force_uN(20.0, 0.0).value(), two = tables.force_uN(20.0, quarter).value();
  EXPECT_LT(two, one);
  EXPECT_NEAR(tables.force_uN(20.0, 0.5 * quarter).value(), 0.5 * (one + two), 1e-9);
  EXPECT_NEAR(tables.force_uN(40.0, 0.0, 2.0).value(), 4.0 * one, 1e-9);
  EXPECT_FALSE(tables.force_uN(60.0, 0.0));
  EXPECT_FALSE(tables.force_uN(20.0, 2.5));
  EXPECT_FALSE(ForceTables("no-such-cell").force_uN(20.0, 0.0));
}

TEST(ForceCrossCheck, SpreadIsTheirDeviationOverTheirMean) {
  EXPECT_TRUE(std::isnan(spread_percent(1.0, {})));
  ForceCrossCheck opinions;
  opinions.table_uN = 3.0;
  EXPECT_NEAR(spread_percent(1.0, opinions), 50.0, 1e-9);
  opinions.point_load_uN = 2.0;
  EXPECT_NEAR(spread_percent(2.0, {2.0, 2.0, 0.0}), 0.0, 1e-6);
  EXPECT_NEAR(spread_percent(1.0, opinions), 100.0 * std::sqrt(2.0 / 3.0) / 2.0, 1e-9);
}

}  // namespace
}  // namespace pellucida
