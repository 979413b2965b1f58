// Telling a dent that something pushes into an outline from the shapes that cells have by themselves.
#include "Dent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "pellucida/tracking/MembraneTracker.h"

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

// A membrane's dark line along that outline, no needle anywhere.
std::vector<std::uint8_t> picture_of(const Eigen::Matrix2Xd& membrane) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(150.0, 2.0);
  std::vector<std::uint8_t> pixels(300 * 260);
  for (int y = 0; y < 260; ++y)
    for (int x = 0; x < 300; ++x) {
      const double off = std::sqrt((membrane.colwise() - Eigen::Vector2d(x, y)).colwise().squaredNorm().minCoeff());
      const double grey = noise(random) - 60.0 * std::exp(-0.5 * off * off / 2.25);
      pixels[static_cast<std::size_t>(y) * 300 + x] = static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0));
    }
  return pixels;
}

TEST(Dent, OneThatNoNeedleExplainsIsAContactWithoutANeedle) {
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kLines;
  MembraneTracker tracker(options);
  Observation seen;
  for (long frame = 0; frame < 16; ++frame) {
    const std::vector<std::uint8_t> pixels = picture_of(outline(1.0, std::max(0.0, 1.5 * (frame - 4.0)), 2.0));
    ImageView view;
    view.data = pixels.data();
    view.width_px = view.row_bytes = 300;
    view.height_px = 260;
    view.pixel_size_um = 0.5;
    seen = tracker.process(view, frame / 30.0, frame);
    ASSERT_TRUE(frame >= 5 || seen.state == CellState::kFree) << frame;
  }
  EXPECT_EQ(seen.state, CellState::kContact);
  EXPECT_FALSE(seen.needle);
  EXPECT_LE(seen.confidence, 0.5);
  EXPECT_TRUE(seen.outer);
}

TEST(Dent, TooFewPointsShowNone) {
  EXPECT_EQ(dent_ratio(Eigen::Matrix2Xd::Zero(2, 0), kCenter, std::nullopt), 0.0);
  EXPECT_EQ(dent_ratio(Eigen::Matrix2Xd::Zero(2, 64), Eigen::Vector2d::Zero(), std::nullopt), 0.0);
}

}  // namespace
}  // namespace pellucida
