// The zona whose two edges are too near each other to be followed: read from the mean profile across its outline.
#include "ThinZona.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "MembraneSnakes.h"

namespace pellucida {
namespace {

constexpr int kSide_px = 160;
constexpr double kOutline_px = 40.0, kLine_px = 0.7;  // px
const Eigen::Vector2d kMiddle_px(81.3, 78.6);

// One or two dark lines of `line_px`, `apart_px` from each other; `shade` brightens the picture from left to right,
// `body` darkens what lies 8 px and more within.
std::vector<std::uint8_t> two_lines(double apart_px, double inner_depth, double noise, double shade = 0.0,
                                    double line_px = kLine_px, double body = 0.0) {
  std::vector<std::uint8_t> pixels;
  std::mt19937 dice(11);
  std::normal_distribution<double> normal(0.0, 1.0);
  const auto line = [&](double d) { return std::exp(-0.5 * d * d / (line_px * line_px)); };
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const double r = (Eigen::Vector2d(x, y) - kMiddle_px).norm();
      const double value = 150.0 - 50.0 * line(r - kOutline_px) - inner_depth * line(r - kOutline_px + apart_px) -
                           body / (1.0 + std::exp(r - kOutline_px + 8.0));
      pixels.push_back(
          static_cast<std::uint8_t>(std::lround(value + shade * (x - kMiddle_px.x()) + noise * normal(dice))));
    }
  return pixels;
}

ThinZona read_zona(const std::vector<std::uint8_t>& pixels, EdgeKind kind = {}, const NeedleZone* needle = nullptr,
                   double line_px = kLine_px) {
  ImageView view;
  view.data = pixels.data();
  view.width_px = view.height_px = kSide_px;
  view.row_bytes = kSide_px;
  Eigen::Matrix2Xd outline(2, 192);
  for (int i = 0; i < 192; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 192;
    outline.col(i) = kMiddle_px + kOutline_px * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return ThinZona::read(FrameSampler(view), outline, kind, line_px, needle);
}

TEST(ThinZona, IsMeasuredFromTwoPixelsOn) {
  for (const double apart_px : {2.1, 2.6, 3.2, 4.0}) {
    const ThinZona seen = read_zona(two_lines(apart_px, 45.0, 4.0, 0.6));
    EXPECT_NEAR(seen.thickness_px, apart_px, 0.25) << apart_px;
    EXPECT_LT(std::abs(seen.thickness_px - apart_px), 3.0 * seen.sigma_px) << apart_px;
    EXPECT_LT(seen.sigma_px, 0.3);
  }
}

TEST(ThinZona, BlurredLinesMayBeFurtherApart) {
  const double blurred_px = 2.2;
  EXPECT_NEAR(read_zona(two_lines(7.5, 45.0, 2.0, 0.0, blurred_px), {}, nullptr, blurred_px).thickness_px, 7.5, 0.3);
  // What gets darker and stays so is no line, and sharp lines so far apart would have been followed.
  EXPECT_EQ(read_zona(two_lines(0.0, 0.0, 2.0, 0.0, blurred_px, 30.0), {}, nullptr, blurred_px).thickness_px, 0.0);
  EXPECT_EQ(read_zona(two_lines(7.5, 45.0, 2.0)).thickness_px, 0.0);
}

TEST(ThinZona, OneLineBoundsIt) {
  for (const double apart_px : {0.0, 0.6}) {
    const ThinZona seen = read_zona(two_lines(apart_px, apart_px > 0.0 ? 45.0 : 0.0, 4.0));
    EXPECT_EQ(seen.thickness_px, 0.0);
    EXPECT_GT(seen.limit_px, 1.2);
    EXPECT_LT(seen.limit_px, 2.5);
  }
}

TEST(ThinZona, APoorPictureSaysNothing) {
  const ThinZona seen = read_zona(two_lines(2.6, 45.0, 90.0));
  EXPECT_EQ(seen.thickness_px, 0.0);
  EXPECT_EQ(seen.limit_px, 0.0);
}

TEST(ThinZona, AStepIsNoLine) {
  EXPECT_EQ(read_zona(two_lines(2.6, 45.0, 2.0), {0.0, 1.0}).limit_px, 0.0);
}

// Tools over a part of the outline leave it as it is.
TEST(ThinZona, WhatTheNeedleCoversDoesNotCount) {
  std::vector<std::uint8_t> pixels = two_lines(2.6, 45.0, 2.0);
  for (int y = 70; y < 90; ++y)
    for (int x = 100; x < kSide_px; ++x) pixels[static_cast<std::size_t>(y * kSide_px + x)] = 20;
  NeedleZone needle;
  needle.tip = {100.0, 80.0};
  needle.direction = {-1.0, 0.0};
  needle.tip_half_width = 10.0;
  EXPECT_NEAR(read_zona(pixels, {}, &needle).thickness_px, 2.6, 0.25);
}

TEST(ThinZona, MostFramesDecide) {
  ThinZonaMean mean;
  EXPECT_EQ(mean.mean().limit_px, 0.0);
  mean.add({2.4, 0.2, 1.8});
  mean.add({2.6, 0.2, 1.8});
  mean.add({0.0, 0.0, 1.8});
  EXPECT_NEAR(mean.mean().thickness_px, 2.5, 1e-12);
  mean.add({0.0, 0.0, 1.8});
  EXPECT_EQ(mean.mean().thickness_px, 0.0);
  EXPECT_NEAR(mean.mean().limit_px, 1.8, 1e-12);
}

}  // namespace
}  // namespace pellucida
