#include "pellucida/core/Statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace pellucida {
namespace {

TEST(Statistics, IntervalOfANormalSampleIsThatOfTheory) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(10.0, 2.0);
  std::vector<double> values;
  for (int k = 0; k < 400; ++k) values.push_back(normal(random));
  const Estimate e = estimate(values);
  EXPECT_EQ(e.count, 400);
  EXPECT_NEAR(e.mean, 10.0, 0.3);
  EXPECT_NEAR(e.median, 10.0, 0.01);
  EXPECT_NEAR(e.upper - e.lower, 2 * 1.96 * 2.0 / 20.0, 0.016);
  EXPECT_LT(e.lower, e.mean);
  EXPECT_GT(e.upper, e.mean);
}

TEST(Statistics, WhatIsNoNumberIsLeftOut) {
  const Estimate e = estimate({1.0, std::numeric_limits<double>::quiet_NaN(), 3.0});
  EXPECT_EQ(e.count, 2);
  EXPECT_DOUBLE_EQ(e.mean, 2.0);
  EXPECT_DOUBLE_EQ(e.median, 2.0);
  EXPECT_TRUE(std::isnan(estimate({}).mean));
}

// R: quantile(c(1, 2, 4, 8), c(0, .25, .5, 1)).
TEST(Statistics, QuantilesAreThoseOfR) {
  const std::vector<double> values{1.0, 2.0, 4.0, 8.0};
  EXPECT_DOUBLE_EQ(quantile(values, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3.0);
  EXPECT_DOUBLE_EQ(quantile(values, 1.0), 8.0);
}

// Worked by hand: p = 0.9, n = 10.
TEST(Statistics, WilsonsInterval) {
  const Share s = share_of(9, 10);
  EXPECT_DOUBLE_EQ(s.value, 0.9);
  EXPECT_NEAR(s.lower, 0.5958, 1e-4);
  EXPECT_NEAR(s.upper, 0.9821, 5e-5);
  EXPECT_NEAR(share_of(200, 200).upper, 1.0, 1e-12);
  EXPECT_LT(share_of(200, 200).lower, 1.0);
  EXPECT_TRUE(std::isnan(share_of(0, 0).value));
}

}  // namespace
}  // namespace pellucida
