#include "EdgeProfile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pellucida {
namespace {

constexpr double kStep = 0.5;
constexpr int kCount = 61;

// A profile across an edge at `place` (px from the first sample): a dark line of depth and width, on a step.
std::vector<float> profile(double place, double depth, double width, double step) {
  std::vector<float> values(kCount);
  for (int j = 0; j < kCount; ++j) {
    const double u = j * kStep - place;
    values[static_cast<std::size_t>(j)] = static_cast<float>(0.6 - depth * std::exp(-u * u / (2.0 * width * width)) +
                                                             step * 0.5 * std::erfc(-u / (width * std::sqrt(2.0))));
  }
  return values;
}

double locate(const EdgeFilter& filter, const std::vector<float>& values, double near) {
  std::vector<float> feature(values.size());
  filter.apply(values.data(), kCount, feature.data());
  return climb_to_peak(feature.data(), kCount, static_cast<int>(std::lround(near / kStep)), 6).position * kStep;
}

TEST(EdgeProfile, DarkLineIsLocatedSubPixel) {
  const EdgeFilter filter(1.3, kStep, {1.0, 0.0});
  for (double place = 14.0; place < 16.0; place += 0.037)
    EXPECT_NEAR(locate(filter, profile(place, 0.2, 1.1, 0.0), 15.0), place, 0.007) << place;
}

TEST(EdgeProfile, BrightLineNeedsTheOtherSign) {
  const EdgeFilter filter(1.3, kStep, {-1.0, 0.0});
  EXPECT_NEAR(locate(filter, profile(15.23, -0.2, 1.1, 0.0), 15.0), 15.23, 0.0026);
}

TEST(EdgeProfile, StepIsLocatedSubPixel) {
  const EdgeFilter up(1.5, kStep, {0.0, 1.0}), down(1.5, kStep, {0.0, -1.0});
  for (double place = 14.0; place < 16.0; place += 0.083) {
    EXPECT_NEAR(locate(up, profile(place, 0.0, 1.0, 0.2), 15.0), place, 0.0036);
    EXPECT_NEAR(locate(down, profile(place, 0.0, 1.0, -0.2), 15.0), place, 0.0036);
  }
}

TEST(EdgeProfile, ConstantProfileGivesNothing) {
  const EdgeFilter filter(1.3, kStep, {1.0, 0.0});
  const std::vector<float> flat(kCount, 0.42F);
  std::vector<float> feature(kCount);
  filter.apply(flat.data(), kCount, feature.data());
  for (const float f : feature) EXPECT_NEAR(f, 0.0F, 1e-6F);
}

TEST(EdgeProfile, NoiseErrorIsAsPredicted) {
  // Position noise = slope noise / curvature. Samples half a pixel apart, each with noise of its own: no sharing.
  const EdgeFilter filter(1.3, kStep, {1.0, 0.0});
  std::mt19937 random(7);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  double squares = 0.0, predicted = 0.0;
  const int trials = 400;
  for (int k = 0; k < trials; ++k) {
    std::vector<float> values = profile(15.1, 0.2, 1.1, 0.0);
    for (float& v : values) v += noise(random);
    std::vector<float> feature(kCount);
    filter.apply(values.data(), kCount, feature.data());
    const Peak peak = climb_to_peak(feature.data(), kCount, 30, 6);
    squares += std::pow(peak.position * kStep - 15.1, 2);
    const double unshared = filter.slope_noise_gain() / std::sqrt(1.0 / kStep);
    predicted += 0.01 * unshared / (-peak.curvature / (kStep * kStep)) / trials;
  }
  const double measured = std::sqrt(squares / trials);
  EXPECT_LT(measured, 0.1);
  EXPECT_NEAR(measured / predicted, 1.0, 0.06);
}

TEST(EdgeProfile, ClimbStopsAtItsReach) {
  std::vector<float> rising(40);
  for (int j = 0; j < 40; ++j) rising[static_cast<std::size_t>(j)] = static_cast<float>(j);
  const Peak peak = climb_to_peak(rising.data(), 40, 10, 5);
  EXPECT_EQ(peak.position, 15.0);
  EXPECT_EQ(peak.curvature, 0.0);
}

TEST(EdgeProfile, ClosedPathFollowsAWaveAndCloses) {
  const int rows = 120, columns = 60;
  std::mt19937 random(11);
  std::normal_distribution<float> noise(0.0F, 0.3F);
  Eigen::MatrixXf reward(rows, columns);
  std::vector<int> truth(rows);
  for (int i = 0; i < rows; ++i) {
    truth[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(30.0 + 15.0 * std::sin(2.0 * M_PI * i / rows)));
    for (int j = 0; j < columns; ++j) reward(i, j) = noise(random);
    reward(i, truth[static_cast<std::size_t>(i)]) += 2.0F;
  }
  const std::vector<int> path = best_closed_path(reward, 2, 0.1F);
  for (int i = 0; i < rows; ++i)
    EXPECT_LE(std::abs(path[static_cast<std::size_t>(i)] - truth[static_cast<std::size_t>(i)]), 1);
  EXPECT_LE(std::abs(path.front() - path.back()), 2);
}

TEST(EdgeProfile, CoupledPathsDoNotHopBetweenTwoLikeLines) {
  // Two equal lines 8 apart, each broken over some rows: alone a path could hop; coupled, both stay.
  const int rows = 100, columns = 50;
  Eigen::MatrixXf reward = Eigen::MatrixXf::Zero(rows, columns);
  for (int i = 0; i < rows; ++i) {
    if (i < 30 || i > 40) reward(i, 32) = 1.0F;
    if (i < 60 || i > 70) reward(i, 24) = 1.0F;
  }
  const PathPair pair = best_closed_path_pair(reward, reward, 4, 12, 0.1F, 0.1F);
  for (int i = 0; i < rows; ++i) {
    EXPECT_EQ(pair.outer[static_cast<std::size_t>(i)], 32);
    EXPECT_EQ(pair.inner[static_cast<std::size_t>(i)], 24);
  }
}

}  // namespace
}  // namespace pellucida
