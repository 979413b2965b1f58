#include "pellucida/batch/EffectSize.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pellucida {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::vector<double> normal_sample(std::mt19937_64& random, int count, double mean) {
  std::normal_distribution<double> normal(mean, 1.0);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (double& value : values) value = normal(random);
  return values;
}

// Worked by hand: means 3 and 5, pooled standard deviation sqrt(2.5), J(8) = Gamma(4) / (2 Gamma(3.5)).
TEST(EffectSize, HedgesG) {
  const double j = 6.0 / (2.0 * 3.3233509704478426);
  EXPECT_NEAR(hedges_g({1, 2, 3, 4, 5}, {3, 4, 5, 6, 7}), j * 2.0 / std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(hedges_g({3, 4, 5, 6, 7}, {1, 2, 3, 4, 5}), -j * 2.0 / std::sqrt(2.5), 1e-12);
  EXPECT_TRUE(std::isnan(hedges_g({1}, {1, 2})));
  EXPECT_TRUE(std::isnan(hedges_g({2, 2}, {2, 2})));
  EXPECT_TRUE(std::isnan(hedges_g({0.1, 0.1, 0.1}, {0.3, 0.3, 0.3})));
}

// 12 of 25 pairs larger... counted by hand: 3 against 1..5 wins 2, loses 2, and so on.
TEST(EffectSize, CliffsDelta) {
  EXPECT_DOUBLE_EQ(cliffs_delta({1, 2, 3, 4, 5}, {3, 4, 5, 6, 7}), (0 + 2 + 4 + 5 + 5) / 25.0);
  EXPECT_DOUBLE_EQ(cliffs_delta({1, 2}, {3, 4}), 1.0);
  EXPECT_DOUBLE_EQ(cliffs_delta({3, 4}, {1, 2}), -1.0);
  EXPECT_DOUBLE_EQ(cliffs_delta({1, 2}, {1, 2}), 0.0);
  EXPECT_TRUE(std::isnan(cliffs_delta({}, {1})));
}

TEST(EffectSize, TheIntervalIsTheSameEveryTimeAndNeedsEnoughValues) {
  const std::vector<double> reference{1, 2, 3, 4, kNoValue}, values{2, 3, 5, 9};
  const EffectSize one = effect_size(hedges_g, reference, values), other = effect_size(hedges_g, reference, values);
  EXPECT_EQ(one.lower, other.lower);
  EXPECT_EQ(one.upper, other.upper);
  EXPECT_LT(one.lower, one.value);
  EXPECT_GT(one.upper, one.value);
  EXPECT_NE(effect_size(hedges_g, {1, 2.3, 3.1, 4.7, 5}, {2.2, 3.9, 5, 9}, 2).lower,
            effect_size(hedges_g, {1, 2.3, 3.1, 4.7, 5}, {2.2, 3.9, 5, 9}, 1).lower);
  const EffectSize few = effect_size(hedges_g, {1, 2, kNoValue, 3}, values);
  EXPECT_FALSE(std::isnan(few.value));
  EXPECT_TRUE(std::isnan(few.lower));
}

// The percentile bootstrap is a little narrow in small samples; docs/limits.md states the figures.
TEST(EffectSize, IntervalsHoldTheTruthAboutAsOftenAsTheySay) {
  constexpr double kShift = 0.8;
  const double true_delta = 2.0 * 0.5 * std::erfc(-kShift / 2.0) - 1.0;  // of two normal distributions
  std::mt19937_64 random(5);
  int g_held = 0, delta_held = 0;
  constexpr int kTrials = 200;
  for (int k = 0; k < kTrials; ++k) {
    const auto reference = normal_sample(random, 15, 0.0), values = normal_sample(random, 15, kShift);
    const EffectSize g = effect_size(hedges_g, reference, values);
    const EffectSize delta = effect_size(cliffs_delta, reference, values);
    g_held += g.lower <= kShift && kShift <= g.upper;
    delta_held += delta.lower <= true_delta && true_delta <= delta.upper;
  }
  RecordProperty("g_held_percent", 100 * g_held / kTrials);
  RecordProperty("delta_held_percent", 100 * delta_held / kTrials);
  EXPECT_GE(g_held, 0.88 * kTrials) << g_held;
  EXPECT_GE(delta_held, 0.88 * kTrials) << delta_held;
  EXPECT_LE(g_held, 0.99 * kTrials) << g_held;
}

}  // namespace
}  // namespace pellucida
