#include "pellucida/haptics/LatencyHistogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace pellucida {
namespace {

TEST(LatencyHistogram, EmptyIsZero) {
  const LatencyHistogram histogram;
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_EQ(histogram.quantile_us(0.5), 0.0);
  EXPECT_EQ(histogram.max_us(), 0.0);
}

TEST(LatencyHistogram, QuantilesAreThoseOfTheSortedValuesToAFewPerCent) {
  LatencyHistogram histogram;
  std::mt19937 random(7);
  std::lognormal_distribution<double> duration(9.0, 1.5);
  std::vector<std::int64_t> all;
  for (int k = 0; k < 50000; ++k) {
    all.push_back(static_cast<std::int64_t>(duration(random)));
    histogram.add_ns(all.back());
  }
  std::sort(all.begin(), all.end());
  for (const double ratio : {0.1, 0.5, 0.9, 0.99, 0.999, 0.9999}) {
    const auto place = static_cast<std::size_t>(ratio * static_cast<double>(all.size() - 1));
    const double expected_us = 1e-3 * static_cast<double>(all[place]);
    EXPECT_NEAR(histogram.quantile_us(ratio), expected_us, 0.04 * expected_us) << ratio;
  }
  EXPECT_EQ(histogram.max_us(), 1e-3 * static_cast<double>(all.back()));
  EXPECT_EQ(histogram.quantile_us(1.0), histogram.max_us());
}

TEST(LatencyHistogram, ExtremesAreCountedToo) {
  LatencyHistogram histogram;
  histogram.add_ns(-5);
  histogram.add_ns(0);
  histogram.add_ns(std::int64_t{1} << 62);
  EXPECT_EQ(histogram.count(), 3U);
  EXPECT_EQ(histogram.quantile_us(0.5), 0.0);
  histogram.clear();
  EXPECT_EQ(histogram.count(), 0U);
}

}  // namespace
}  // namespace pellucida
