#include "pellucida/core/Ring.h"

#include <gtest/gtest.h>

#include <thread>

namespace pellucida {
namespace {

TEST(Ring, KeepsOrderAndCountsWhatItRefuses) {
  Ring<int> ring(2);
  EXPECT_TRUE(ring.push(1));
  EXPECT_TRUE(ring.push(2));
  EXPECT_FALSE(ring.push(3));
  EXPECT_EQ(ring.dropped_count(), 1U);
  EXPECT_EQ(ring.wait({}), 1);
  EXPECT_TRUE(ring.push(4));
  EXPECT_EQ(ring.wait({}), 2);
  EXPECT_EQ(ring.wait({}), 4);
}

TEST(Ring, WhatIsInsideCanBeReadAfterClose) {
  Ring<int> ring(4);
  ring.push(1);
  ring.close();
  EXPECT_FALSE(ring.push(2));
  EXPECT_EQ(ring.wait({}), 1);
  EXPECT_FALSE(ring.wait({}));
}

TEST(Ring, PushWaitLosesNothing) {
  Ring<int> ring(2);
  constexpr int kCount = 20000;
  std::jthread writer([&] {
    for (int i = 0; i < kCount; ++i) ring.push_wait(i);
    ring.close();
  });
  int expected_next = 0;
  while (auto value = ring.wait({})) ASSERT_EQ(*value, expected_next++);
  EXPECT_EQ(expected_next, kCount);
  EXPECT_EQ(ring.dropped_count(), 0U);
  EXPECT_FALSE(ring.push_wait(1));
}

TEST(Ring, NothingIsLostBetweenTwoThreads) {
  Ring<int> ring(64);
  constexpr int kCount = 20000;
  int refused_count = 0;
  std::jthread writer([&] {
    for (int i = 0; i < kCount; ++i) refused_count += ring.push(i) ? 0 : 1;
    ring.close();
  });
  int last = -1;
  int taken_count = 0;
  while (auto value = ring.wait({})) {
    ASSERT_GT(*value, last);
    last = *value;
    ++taken_count;
  }
  writer.join();
  EXPECT_EQ(taken_count + refused_count, kCount);
  EXPECT_EQ(ring.dropped_count(), static_cast<std::uint64_t>(refused_count));
}

}  // namespace
}  // namespace pellucida
