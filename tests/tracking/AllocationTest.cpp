// Memory asked for in a frame, once warm: what its observation holds, and as little as can be beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "pellucida/tracking/MembraneTracker.h"
#include "tracking/AllocationCounter.h"
#include "tracking/FrameLoop.h"

namespace pellucida {
namespace {

// What a frame may cost beyond its observation: the aim is 0.
constexpr std::size_t kUsualAllocations = 600, kMostAllocations = 850;  // networks read

// The arrays an observation is handed out with: three for each membrane, one for each tool.
std::size_t array_count(const Observation& seen) {
  std::size_t count = 0;
  for (const auto* contour : {&seen.outer, &seen.inner, &seen.oolemma}) count += contour->has_value() ? 3 : 0;
  return count + (seen.needle ? 1 : 0) + (seen.holder ? 1 : 0);
}

TEST(Allocation, TheCounterCounts) {
  const test::AllocationCounter counter;
  const std::vector<double> some(1000, 1.0);
  const Eigen::VectorXd more = Eigen::VectorXd::Ones(1000);
  EXPECT_EQ(counter.count(), 2U) << some.front() + more[0];
  EXPECT_GE(counter.bytes(), 16000U);
}

class Allocation : public testing::TestWithParam<const char*> {};

TEST_P(Allocation, AWarmFrameCostsItsObservation) {
  const test::FrameLoop loop(load_scenario(GetParam()));
  MembraneTracker tracker;
  // Warm: approach, touch, the whole depth, and back.
  std::size_t k = 0;
  for (; k < 2 * loop.size(); ++k) tracker.process(loop.view(k), static_cast<double>(k) / 30.0, static_cast<long>(k));
  std::vector<std::size_t> extra, bytes;
  for (; k < 4 * loop.size(); ++k) {
    const ImageView view = loop.view(k);
    const test::AllocationCounter counter;
    const Observation seen = tracker.process(view, static_cast<double>(k) / 30.0, static_cast<long>(k));
    const std::size_t count = counter.count();
    bytes.push_back(counter.bytes());
    ASSERT_TRUE(seen.outer.has_value()) << "frame " << k;
    extra.push_back(count - std::min(count, array_count(seen)));
  }
  std::sort(extra.begin(), extra.end());
  std::sort(bytes.begin(), bytes.end());
  std::printf(
      "allocations a frame beyond the observation's arrays: median %zu, most %zu; bytes: median %zu, most %zu\n",
      extra[extra.size() / 2], extra.back(), bytes[bytes.size() / 2], bytes.back());
  EXPECT_LE(extra[extra.size() / 2], kUsualAllocations);
  EXPECT_LE(extra.back(), kMostAllocations);
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Allocation, testing::Values("default", "noisy"));

}  // namespace
}  // namespace pellucida
