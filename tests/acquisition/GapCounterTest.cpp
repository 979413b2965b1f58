#include "GapCounter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace pellucida {
namespace {

TEST(GapCounter, EvenStampsHaveNoGap) {
  GapCounter gaps(30.0);
  for (long i = 0; i < 1000; ++i) {
    const auto place = gaps.add(static_cast<double>(i) / 30.0);
    EXPECT_EQ(place.frame_index, i);
    EXPECT_EQ(place.gap_count, 0);
  }
}

TEST(GapCounter, LostFramesAreCountedAndNumbered) {
  GapCounter gaps(10.0);
  EXPECT_EQ(gaps.add(5.0).frame_index, 0);
  EXPECT_EQ(gaps.add(5.1).frame_index, 1);
  const auto place = gaps.add(5.5);
  EXPECT_EQ(place.frame_index, 5);
  EXPECT_EQ(place.gap_count, 3);
  EXPECT_EQ(gaps.add(5.6).gap_count, 0);
}

// Any jitter below half a period is no loss, and any set of lost frames is found in it.
TEST(GapCounter, FindsLossesUnderJitter) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-0.24, 0.24);
    std::bernoulli_distribution lost(0.2);
    GapCounter gaps(25.0);
    long last = -1;
    for (long i = 0; i < 500; ++i) {
      if (i > 0 && lost(random)) continue;
      const auto place = gaps.add((static_cast<double>(i) + jitter(random)) / 25.0);
      ASSERT_EQ(place.frame_index, i) << "seed " << seed;
      ASSERT_EQ(place.gap_count, i - last - 1) << "seed " << seed;
      last = i;
    }
  }
}

TEST(GapCounter, StampsThatStandStillOrGoBackAreTheNextFrame) {
  GapCounter gaps(30.0);
  gaps.add(1.0);
  EXPECT_EQ(gaps.add(1.0).frame_index, 1);
  EXPECT_EQ(gaps.add(0.5).frame_index, 2);
  EXPECT_EQ(gaps.add(std::numeric_limits<double>::quiet_NaN()).frame_index, 3);
}

}  // namespace
}  // namespace pellucida
