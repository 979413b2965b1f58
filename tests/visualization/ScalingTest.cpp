#include "pellucida/visualization/Scaling.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(Scaling, CeilingsAndFloorsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(nice_ceiling(0.031, 0.001), 0.05);
  EXPECT_DOUBLE_EQ(nice_ceiling(5.0, 0.001), 5.0);
  EXPECT_DOUBLE_EQ(nice_ceiling(5.1, 0.001), 10.0);
  EXPECT_DOUBLE_EQ(nice_ceiling(0.0, 0.001), 0.001);
  EXPECT_DOUBLE_EQ(nice_floor(49.0), 20.0);
  EXPECT_DOUBLE_EQ(nice_floor(50.0), 50.0);
  EXPECT_DOUBLE_EQ(nice_floor(0.15), 0.1);
}

TEST(NiceRange, GrowsAtOnceAndShrinksOnlyAfterALongWhile) {
  NiceRange range(0.001);
  EXPECT_DOUBLE_EQ(range.update(0.3), 0.5);
  EXPECT_DOUBLE_EQ(range.update(0.01), 0.5);
  for (int i = 0; i < 200; ++i) range.update(0.01);
  EXPECT_DOUBLE_EQ(range.upper(), 0.01);
}

TEST(NiceRange, DoesNotFlickerAboutABound) {
  NiceRange range(0.001);
  range.update(0.51);
  for (int i = 0; i < 500; ++i) EXPECT_DOUBLE_EQ(range.update(i % 2 ? 0.49 : 0.51), 1.0);
}

}  // namespace
}  // namespace pellucida
