#include "pellucida/visualization/Scaling.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

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
