#include "ArrivalQueue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <thread>
#include <vector>

namespace pellucida {
namespace {

TEST(ArrivalQueue, FramesComeOutInTheOrderOfTheirArrivalWhateverOrderTheySettleIn) {
  ArrivalQueue<long> queue;
  for (const long key : {1, 2, 3}) EXPECT_TRUE(queue.announce(key, -key, 10));
  EXPECT_TRUE(queue.settle(3, 3, 30));
  EXPECT_TRUE(queue.settle(1, 1, 30));
  EXPECT_EQ(queue.wait({}), 1);
  EXPECT_TRUE(queue.settle(2, 2, 30));
  EXPECT_EQ(queue.wait({}), 2);
  EXPECT_EQ(queue.wait({}), 3);
  EXPECT_FALSE(queue.settle(2, 2, 30)) << "settled twice";
  EXPECT_FALSE(queue.settle(9, 9, 30)) << "never announced";
}

TEST(ArrivalQueue, WhatIsBesideTheFramesDoesNotWaitForThem) {
  ArrivalQueue<long> queue;
  queue.announce(1, 1, 10);
  EXPECT_TRUE(queue.push(100, 1));
  EXPECT_EQ(queue.wait({}), 100);
}

// Nobody takes anything, as when a disk has stalled: whoever brings something goes on all the same.
TEST(ArrivalQueue, NobodyWaitsForRoom) {
  ArrivalQueue<long> queue;
  for (long key = 0; key < 10000; ++key) {
    ASSERT_TRUE(queue.announce(key, key, 100));
    ASSERT_TRUE(queue.settle(key, key, 100));
    ASSERT_TRUE(queue.push(key, 1));
  }
  EXPECT_EQ(queue.load().byte_count(), 10000U * 101U);
}

TEST(ArrivalQueue, CountsWhatWaits) {
  ArrivalQueue<long> queue;
  queue.announce(1, 1, 10);
  queue.announce(2, 2, 10);
  queue.settle(2, 2, 50);
  EXPECT_EQ(queue.load().unsettled_bytes, 60U);
  EXPECT_EQ(queue.load().ready_bytes, 0U);
  queue.settle(1, 1, 40);
  EXPECT_EQ(queue.load().unsettled_bytes, 0U);
  EXPECT_EQ(queue.load().ready_bytes, 90U);
  queue.wait({});
  EXPECT_EQ(queue.load().byte_count(), 50U);
  queue.wait({});
  EXPECT_EQ(queue.load().byte_count(), 0U);
}

TEST(ArrivalQueue, ClosingLetsUnsettledFramesOutAndTakesNothingMore) {
  ArrivalQueue<long> queue;
  queue.announce(1, -1, 10);
  queue.announce(2, -2, 10);
  queue.settle(2, 2, 10);
  queue.close();
  EXPECT_FALSE(queue.announce(3, 3, 10));
  EXPECT_FALSE(queue.settle(1, 1, 10));
  EXPECT_FALSE(queue.push(4, 10));
  EXPECT_EQ(queue.wait({}), -1);
  EXPECT_EQ(queue.wait({}), 2);
  EXPECT_FALSE(queue.wait({}));
}

TEST(ArrivalQueue, AWaitingWriterCanBeStopped) {
  ArrivalQueue<long> queue;
  std::jthread writer([&](std::stop_token stop) { EXPECT_FALSE(queue.wait(stop)); });
  writer.request_stop();
  writer.join();
}

// A camera's thread announces, three threads settle as a chain of steps would, others add events, one writes.
TEST(ArrivalQueue, ManyThreadsLoseNothingAndKeepTheOrder) {
  constexpr long kFrameCount = 3000;
  constexpr long kEventCount = 1000;
  ArrivalQueue<long> queue;
  std::vector<long> frames;
  long event_count = 0;
  std::jthread writer([&] {
    while (const auto item = queue.wait({})) {
      if (*item >= 0) frames.push_back(*item);
      event_count += *item < 0 ? 1 : 0;
    }
  });
  {
    std::atomic<long> announced{0};
    std::vector<std::jthread> threads;
    threads.emplace_back([&] {
      for (long key = 0; key < kFrameCount; ++key) {
        queue.announce(key, key, 8);
        announced = key + 1;
      }
    });
    for (long part = 0; part < 3; ++part) {
      threads.emplace_back([&, part] {
        for (long key = part; key < kFrameCount; key += 3) {
          while (announced <= key) std::this_thread::yield();
          EXPECT_TRUE(queue.settle(key, key, 16));
        }
      });
    }
    threads.emplace_back([&] {
      for (long i = 0; i < kEventCount; ++i) queue.push(-1, 1);
      EXPECT_LE(queue.load().unsettled_bytes, static_cast<std::size_t>(16 * kFrameCount));
    });
  }
  queue.close();
  writer.join();
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFrameCount));
  for (long key = 0; key < kFrameCount; ++key) ASSERT_EQ(frames[static_cast<std::size_t>(key)], key);
  EXPECT_EQ(event_count, kEventCount);
  EXPECT_EQ(queue.load().byte_count(), 0U);
}

}  // namespace
}  // namespace pellucida
