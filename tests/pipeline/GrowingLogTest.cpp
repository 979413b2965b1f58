#include "GrowingLog.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace pellucida {
namespace {

TEST(GrowingLog, GivesWhatIsNewToEachReader) {
  GrowingLog<std::string> log;
  EXPECT_TRUE(log.since(0).empty());
  log.append("a");
  log.append("b");
  EXPECT_EQ(log.since(0), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(log.since(1), (std::vector<std::string>{"b"}));
  EXPECT_TRUE(log.since(2).empty());
  EXPECT_TRUE(log.since(7).empty());
}

TEST(GrowingLog, AReaderMissesNothingOfManyWriters) {
  constexpr std::size_t kCount = 2000;
  GrowingLog<std::string> log;
  std::size_t seen = 0;
  {
    std::jthread one([&] {
      for (std::size_t i = 0; i < kCount; ++i) log.append("one of the first writer's items");
    });
    std::jthread two([&] {
      for (std::size_t i = 0; i < kCount; ++i) log.append("one of the second writer's items");
    });
    while (seen < 2 * kCount) seen += log.since(seen).size();
  }
  EXPECT_EQ(log.since(0).size(), 2 * kCount);
}

}  // namespace
}  // namespace pellucida
