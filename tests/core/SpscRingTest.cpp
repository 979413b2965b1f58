#include "pellucida/core/SpscRing.h"

#include <gtest/gtest.h>

#include <thread>

namespace pellucida {
namespace {

TEST(SpscRing, RefusesAndCountsWhenFull) {
  SpscRing<int, 4> ring;
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(4));
  EXPECT_EQ(ring.dropped_count(), 1U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(ring.pop(), i);
  EXPECT_FALSE(ring.pop());
}

TEST(SpscRing, EverythingArrivesInOrder) {
  SpscRing<int, 256> ring;
  constexpr int kCount = 200000;
  std::jthread writer([&] {
    for (int i = 0; i < kCount; ++i) {
      while (!ring.push(i)) std::this_thread::yield();
    }
  });
  for (int i = 0; i < kCount;) {
    const auto value = ring.pop();
    if (!value) continue;
    ASSERT_EQ(*value, i);
    ++i;
  }
}

}  // namespace
}  // namespace pellucida
