#include "pellucida/core/Clock.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace pellucida {
namespace {

TEST(Clock, SteadyClockStartsAtZeroAndNeverGoesBack) {
  const SteadyClock clock;
  double last_s = clock.now_s();
  EXPECT_GE(last_s, 0.0);
  for (int i = 0; i < 1000; ++i) {
    const double now_s = clock.now_s();
    ASSERT_GE(now_s, last_s);
    last_s = now_s;
  }
}

TEST(Clock, RecordedClockFollowsTheNewestStamp) {
  RecordedClock clock;
  clock.follow(2.0);
  clock.follow(1.0);
  EXPECT_DOUBLE_EQ(clock.now_s(), 2.0);

  // Many followers: the latest stamp wins, whatever its origin.
  std::vector<std::jthread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&clock, t] {
      for (int i = 0; i < 1000; ++i) clock.follow(2.0 + 0.001 * i + 0.0001 * t);
    });
  }
  threads.clear();
  EXPECT_DOUBLE_EQ(clock.now_s(), 2.0 + 0.999 + 0.0003);
}

TEST(Clock, ManualClockIsTurnedByHand) {
  ManualClock clock;
  clock.advance(0.25);
  clock.advance(0.25);
  EXPECT_DOUBLE_EQ(clock.now_s(), 0.5);
}

}  // namespace
}  // namespace pellucida
