// Telling a dent that something pushes into an outline from the shapes that cells have by themselves.
#include "Dent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pellucida {
namespace {

constexpr double kRadius = 60.0;
const Eigen::Vector2d kCenter(150.0, 130.0);

// An ellipse of that aspect with a dimple of `depth_px` at `angle`, 20 degrees wide, and noise.
Eigen::Matrix2Xd outline(double aspect, double depth_px, double angle, double noise_px = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1.0);
  Eigen::Matrix2Xd points(2, 128);
  for (int i = 0; i < 128; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 128;
    const double off = std::remainder(a - angle, 2.0 * std::numbers::pi) / 0.35;
    const double radius = kRadius - depth_px * std::exp(-0.5 * off * off) + noise_px * noise(random);
    points.col(i) = kCenter + radius * Eigen::Vector2d(std::cos(a), aspect * std::sin(a));
  }
  return points;
}

TEST(Dent, IsAsDeepAsItWasMade) {
  for (const double angle : {0.0, 0.7, 2.0, 4.4})
    for (const double depth : {6.0, 12.0, 24.0})
      EXPECT_NEAR(dent_ratio(outline(1.0, depth, angle), kCenter, std::nullopt), depth / kRadius,
                  0.25 * depth / kRadius)
          << angle << ' ' << depth;
}

TEST(Dent, RoundAndOvalCellsHaveNone) {
  for (const double aspect : {1.0, 1.05, 1.15})
    EXPECT_LT(dent_ratio(outline(aspect, 0.0, 0.0, 0.5), kCenter, std::nullopt), 0.02) << aspect;
}

TEST(Dent, ACentreThatIsOffChangesNothing) {
  const Eigen::Matrix2Xd dented = outline(1.0, 12.0, 1.0);
  EXPECT_NEAR(dent_ratio(dented, kCenter + Eigen::Vector2d(4.0, -3.0), std::nullopt),
              dent_ratio(dented, kCenter, std::nullopt), 0.02);
}

TEST(Dent, WhatTheHolderDrawsInDoesNotCount) {
  const Eigen::Vector2d holder(std::cos(2.0), std::sin(2.0));
  EXPECT_LT(dent_ratio(outline(1.0, 12.0, 2.0), kCenter, holder), 0.05);
  EXPECT_GT(dent_ratio(outline(1.0, 12.0, 2.0 + std::numbers::pi), kCenter, holder), 0.15);
}

TEST(Dent, TooFewPointsShowNone) {
  EXPECT_EQ(dent_ratio(Eigen::Matrix2Xd::Zero(2, 0), kCenter, std::nullopt), 0.0);
  EXPECT_EQ(dent_ratio(Eigen::Matrix2Xd::Zero(2, 64), Eigen::Vector2d::Zero(), std::nullopt), 0.0);
}

}  // namespace
}  // namespace pellucida
