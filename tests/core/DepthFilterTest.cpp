#include "pellucida/core/DepthFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pellucida {
namespace {

constexpr double kFrame_s = 1.0 / 30.0;

TEST(DepthFilter, FollowsASteadyRampWithoutLag) {
  DepthFilter filter;
  for (int frame = 0; frame < 90; ++frame) {
    const double depth = 0.6 * frame;
    const auto estimate = filter.update(frame * kFrame_s, depth, 0.2);
    if (frame <= 10) continue;
    EXPECT_NEAR(estimate.depth_um, depth, 2e-4);
  }
}

TEST(DepthFilter, TakesNoiseOffAHoldAndSaysHowMuchIsLeft) {
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, 0.3);
  DepthFilter filter;
  double squares = 0.0, sigma = 0.0;
  int count = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const auto estimate = filter.update(frame * kFrame_s, 20.0 + noise(generator), 0.3);
    if (frame < 60) continue;
    squares += std::pow(estimate.depth_um - 20.0, 2);
    sigma = estimate.sigma_um;
    ++count;
  }
  const double rms = std::sqrt(squares / count);
  EXPECT_LT(rms, 0.8 * 0.3);
  EXPECT_NEAR(rms, sigma, 0.35 * sigma);
}

TEST(DepthFilter, FollowsStartStopAndReversalWithinAFrameOrTwo) {
  // Rest, in at 20 um/s, hold, out at 40 um/s.
  const auto path = [](double t) {
    if (t < 1.0) return 0.0;
    if (t < 3.0) return 20.0 * (t - 1.0);
    if (t < 4.0) return 40.0;
    return std::max(0.0, 40.0 - 40.0 * (t - 4.0));
  };
  DepthFilter filter;
  double worst = 0.0;
  for (int frame = 0; frame < 160; ++frame) {
    const double t = frame * kFrame_s;
    worst = std::max(worst, std::abs(filter.update(t, path(t), 0.2).depth_um - path(t)));
  }
  EXPECT_LT(worst, 0.7);
}

TEST(DepthFilter, FollowsAHaltHoweverVaguelyTheDepthIsMeasured) {
  for (const double sigma_um : {0.05, 0.2, 0.5, 1.0, 2.0}) {
    DepthFilter filter;
    double beyond_um = 0.0;
    for (int frame = 0; frame < 60; ++frame) {
      const double depth_um = std::min(20.0, 1.0 * frame);
      beyond_um = std::max(beyond_um, filter.update(frame * kFrame_s, depth_um, sigma_um).depth_um - depth_um);
    }
    // A filter of one constant speed runs on by two to three standard deviations.
    EXPECT_LT(beyond_um, 1.3 * sigma_um) << sigma_um;
  }
}

TEST(DepthFilter, BeginsAnewAfterAGapOrWhenTimeGoesBack) {
  DepthFilter filter;
  for (int frame = 0; frame < 30; ++frame) filter.update(frame * kFrame_s, frame * 0.5, 0.2);
  EXPECT_DOUBLE_EQ(filter.update(10.0, 3.0, 0.2).depth_um, 3.0);
  EXPECT_DOUBLE_EQ(filter.update(2.0, 7.0, 0.2).depth_um, 7.0);
  EXPECT_GE(filter.update(2.0 + kFrame_s, -1.0, 0.2).depth_um, 0.0);
}

}  // namespace
}  // namespace pellucida
