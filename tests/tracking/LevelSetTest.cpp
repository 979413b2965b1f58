// The level set, from a rough outline into the edge near by.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "ContourMath.h"
#include "LevelSetOutline.h"

namespace pellucida {
namespace {

// A dark ellipse on a brighter, noisy ground.
GrayImage ellipse(double a, double b, float noise_sigma) {
  GrayImage image;
  image.width = 320;
  image.height = 260;
  std::mt19937 random(9);
  std::normal_distribution<float> noise(0.0F, noise_sigma);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double rho = std::hypot((x - 160.0) / a, (y - 130.0) / b);
      image.pixels.push_back(0.6F - 0.25F / static_cast<float>(1.0 + std::exp((rho - 1.0) * 40.0)) + noise(random));
    }
  return image;
}

Eigen::Matrix2Xd circle(double x, double y, double radius) {
  Eigen::Matrix2Xd points(2, 40);
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 40;
    points.col(i) << x + radius * std::cos(angle), y + radius * std::sin(angle);
  }
  return points;
}

double worst_ratio(const Eigen::Matrix2Xd& points, double a, double b) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    worst = std::max(worst, std::abs(std::hypot((points(0, i) - 160.0) / a, (points(1, i) - 130.0) / b) - 1.0));
  return worst;
}

TEST(LevelSetOutline, SettlesIntoAnEllipseFromACircle) {
  const GrayImage image = ellipse(80.0, 66.0, 0.01F);
  const auto outline = refine_by_level_set(image, circle(164.0, 127.0, 74.0));
  ASSERT_TRUE(outline);
  EXPECT_EQ(outline->cols(), 128);
  EXPECT_GT(contour::signed_area(*outline), 0.0);
  EXPECT_LT(worst_ratio(*outline, 80.0, 66.0), 0.023);
}

TEST(LevelSetOutline, GrowsFromWithinWhenAsked) {
  const GrayImage image = ellipse(80.0, 66.0, 0.01F);
  LevelSetSettings settings;
  settings.propagation = 1.0;
  settings.margin_ratio = 1.5;
  settings.radius_px = 20;
  settings.iterations = 400;
  const auto outline = refine_by_level_set(image, circle(155.0, 132.0, 40.0), settings);
  ASSERT_TRUE(outline);
  EXPECT_LT(worst_ratio(*outline, 80.0, 66.0), 0.04);
}

TEST(LevelSetOutline, OrientationDoesNotMatter) {
  const GrayImage image = ellipse(80.0, 66.0, 0.01F);
  const Eigen::Matrix2Xd start = circle(164.0, 127.0, 74.0), reversed = start.rowwise().reverse();
  const auto one = refine_by_level_set(image, start), other = refine_by_level_set(image, reversed);
  ASSERT_TRUE(one && other);
  EXPECT_LT((*one - *other).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(LevelSetOutline, NothingFromTooLittle) {
  const GrayImage image = ellipse(80.0, 66.0, 0.01F);
  EXPECT_FALSE(refine_by_level_set(image, circle(160.0, 130.0, 1.0)));
  EXPECT_FALSE(refine_by_level_set(image, circle(160.0, 130.0, 70.0).leftCols(2)));
}

}  // namespace
}  // namespace pellucida
