#include "pellucida/core/LatestValue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <thread>

namespace pellucida {
namespace {

// A value wide enough to be torn if the hand-over were wrong.
struct Wide {
  std::uint64_t word[16];
};

TEST(LatestValue, NothingFreshUntilPublished) {
  LatestValue<int> slot;
  EXPECT_FALSE(slot.refresh());
  EXPECT_EQ(slot.value(), 0);
  slot.publish(5);
  slot.publish(6);
  EXPECT_TRUE(slot.refresh());
  EXPECT_EQ(slot.value(), 6);
  EXPECT_FALSE(slot.refresh());
  EXPECT_EQ(slot.value(), 6);
}

TEST(LatestValue, NeverTornNeverBackInTime) {
  LatestValue<Wide> slot;
  constexpr std::uint64_t kCount = 200000;
  std::jthread writer([&] {
    for (std::uint64_t i = 1; i <= kCount; ++i) {
      Wide value;
      for (auto& word : value.word) word = i;
      slot.publish(value);
    }
  });
  std::uint64_t last = 0;
  while (last < kCount) {
    if (!slot.refresh()) continue;
    const Wide& value = slot.value();
    for (const auto word : value.word) ASSERT_EQ(word, value.word[0]);
    ASSERT_GT(value.word[0], last);
    last = value.word[0];
  }
}

}  // namespace
}  // namespace pellucida
