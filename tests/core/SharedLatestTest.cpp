#include "pellucida/core/SharedLatest.h"

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace pellucida {
namespace {

TEST(SharedLatest, TheNewestWinsAndOverwrittenOnesAreCounted) {
  SharedLatest<int> exchange;
  EXPECT_FALSE(exchange.peek());
  EXPECT_FALSE(exchange.publish(1));
  EXPECT_EQ(exchange.publish(2), 1);  // what it replaced unread comes back
  EXPECT_EQ(exchange.peek(), 2);
  EXPECT_EQ(exchange.sequence(), 2U);
  EXPECT_EQ(exchange.overwritten_count(), 1U);
  EXPECT_EQ(exchange.wait({}), 2);
  EXPECT_FALSE(exchange.publish(3));
  EXPECT_EQ(exchange.overwritten_count(), 1U);
}

TEST(SharedLatest, CloseEndsTheWaitAfterTheLastValue) {
  SharedLatest<int> exchange;
  exchange.publish(7);
  exchange.close();
  EXPECT_EQ(exchange.wait({}), 7);
  EXPECT_FALSE(exchange.wait({}));
}

TEST(SharedLatest, StopEndsTheWait) {
  SharedLatest<int> exchange;
  bool ended = false;
  std::jthread reader([&](std::stop_token stop) { ended = !exchange.wait(stop); });
  reader.request_stop();
  reader.join();
  EXPECT_TRUE(ended);
}

TEST(SharedLatest, ReadersNeverSeeTimeGoBack) {
  SharedLatest<std::shared_ptr<const int>> exchange;
  constexpr int kCount = 20000;
  std::jthread writer([&] {
    for (int i = 1; i <= kCount; ++i) exchange.publish(std::make_shared<const int>(i));
    exchange.close();
  });
  int last = 0;
  int taken_count = 0;
  while (auto value = exchange.wait({})) {
    ASSERT_GT(**value, last);
    last = **value;
    ++taken_count;
  }
  EXPECT_EQ(last, kCount);
  writer.join();
  EXPECT_EQ(exchange.overwritten_count(), static_cast<std::uint64_t>(kCount - taken_count));
}

}  // namespace
}  // namespace pellucida
