#include "pellucida/core/RoundNumbers.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

TEST(RoundNumbers, CeilingsAndFloorsAreOneTwoFive) {
  EXPECT_DOUBLE_EQ(nice_ceiling(0.031, 0.001), 0.05);
  EXPECT_DOUBLE_EQ(nice_ceiling(5.0, 0.001), 5.0);
  EXPECT_DOUBLE_EQ(nice_ceiling(5.1, 0.001), 10.0);
  EXPECT_DOUBLE_EQ(nice_ceiling(0.0, 0.001), 0.001);
  EXPECT_DOUBLE_EQ(nice_floor(49.0), 20.0);
  EXPECT_DOUBLE_EQ(nice_floor(50.0), 50.0);
  EXPECT_DOUBLE_EQ(nice_floor(0.15), 0.1);
}

TEST(RoundNumbers, TicksInsideEndWithinTheRange) {
  EXPECT_EQ(round_ticks(0.0, 7.5, TickEnds::kInside), (std::vector<double>{0, 2, 4, 6}));
  EXPECT_EQ(round_ticks(0.0, 44.0, TickEnds::kInside), (std::vector<double>{0, 10, 20, 30, 40}));
  const auto small = round_ticks(1.23, 1.27, TickEnds::kInside);
  ASSERT_FALSE(small.empty());
  EXPECT_NEAR(small.front(), 1.23, 1e-9);
  EXPECT_NEAR(small.back(), 1.27, 1e-9);
}

TEST(RoundNumbers, TicksOutsideEncloseTheRange) {
  EXPECT_EQ(round_ticks(0.0, 10.0, TickEnds::kOutside), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(round_ticks(0.3, 7.2, TickEnds::kOutside), (std::vector<double>{0, 2, 4, 6, 8}));
  EXPECT_EQ(round_ticks(95.0, 105.0, TickEnds::kOutside), (std::vector<double>{94, 96, 98, 100, 102, 104, 106}));
  for (const double scale : {1e-6, 1.0, 1e6}) {
    const auto ticks = round_ticks(-1.37 * scale, 2.91 * scale, TickEnds::kOutside);
    EXPECT_LE(ticks.front(), -1.37 * scale);
    EXPECT_GE(ticks.back(), 2.91 * scale);
    EXPECT_LE(ticks.size(), 9U);
  }
}

}  // namespace
}  // namespace pellucida
