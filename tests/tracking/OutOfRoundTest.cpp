// The outline of a cell at rest that is no circle, and where a needle meets it.
#include "OutOfRound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "RestGeometry.h"

namespace pellucida {
namespace {

const Eigen::Vector2d kCenter(150.0, 130.0);
constexpr double kRadius = 60.0;
constexpr int kOutlinePoints = 192;

Eigen::Vector2d toward(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Of an ellipse with its long axis along x, of the area of the circle of `kRadius`.
double ellipse_at(double aspect, double angle) {
  const double root = std::sqrt(aspect);
  return kRadius / std::hypot(std::cos(angle) / root, std::sin(angle) * root);
}

/// That ellipse, turned, with noise and, over a tenth of it, something else that was taken for the outline.
Eigen::Matrix2Xd outline(double aspect, double turned_rad, double noise_px = 0.0, double elsewhere_px = 0.0) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  Eigen::Matrix2Xd points(2, kOutlinePoints);
  for (int i = 0; i < kOutlinePoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kOutlinePoints;
    const double off = i < kOutlinePoints / 10 ? elsewhere_px : 0.0;
    points.col(i) = kCenter + (ellipse_at(aspect, angle - turned_rad) + noise_px * noise(random) + off) * toward(angle);
  }
  return points;
}

const contour::Circle kCircle{kCenter, kRadius, 1.0, 0.0};

TEST(OutOfRound, AnOvalIsFoundWithinAThousandthOfItsRadius) {
  for (const double aspect : {1.0, 1.08, 1.15, 1.0 / 1.15}) {
    const Eigen::Matrix2Xd points = outline(aspect, 0.4);
    const OutOfRound shape = OutOfRound::of(points, kCircle);
    for (double angle = 0.0; angle < 6.2; angle += 0.3) {
      EXPECT_NEAR(kRadius + shape.at(toward(angle)), ellipse_at(aspect, angle - 0.4), 0.003 * kRadius) << aspect;
      // As it was before the cell turned, and after it has.
      EXPECT_NEAR(shape.turned_back(0.4).at(toward(angle), 0.4), shape.at(toward(angle)), 1e-9);
    }
    const Eigen::Matrix2Xd round = shape.rounded(points, kCenter);
    for (int i = 0; i < kOutlinePoints; ++i) EXPECT_NEAR((round.col(i) - kCenter).norm(), kRadius, 0.003 * kRadius);
  }
}

TEST(OutOfRound, NoiseIsNotTheShapeAndALimbElsewhereCountsAQuarter) {
  const OutOfRound round = OutOfRound::of(outline(1.0, 0.0, 0.3), kCircle);
  for (double angle = 0.0; angle < 6.2; angle += 0.3) EXPECT_NEAR(round.at(toward(angle)), 0.0, 0.2);
  const OutOfRound::Fit oval = OutOfRound::fit(outline(1.1, 0.0, 0.3, 12.0), kCircle);
  const Eigen::Matrix2Xd without = outline(1.1, 0.0);
  for (int i = 0; i < kOutlinePoints; ++i) {
    const Eigen::Vector2d d = without.col(i) - oval.circle.center;
    EXPECT_NEAR(oval.circle.radius + oval.shape.at(d.normalized()), d.norm(), 0.25 * 12.0) << i;
  }
}

TEST(OutOfRound, WhatNoCellIsCountsAsRound) {
  const OutOfRound shape = OutOfRound::of(outline(1.8, 0.0), kCircle);
  EXPECT_EQ(shape.at(toward(0.0)), 0.0);
  EXPECT_EQ(OutOfRound::of(outline(1.1, 0.0).leftCols(10), kCircle).at(toward(0.0)), 0.0);
}

// As a circle fitted robustly does: on the near flat side, larger than the cell.
TEST(OutOfRound, ACircleThatHasSettledOnOneSideOfAnOvalMovesToItsMiddle) {
  constexpr double kAspect = 1.2;
  const Eigen::Matrix2Xd points = outline(kAspect, 0.4, 0.1);
  const contour::Circle settled{kCenter + 0.16 * kRadius * toward(0.4 + 0.5 * std::numbers::pi), 1.1 * kRadius, 0.4,
                                1.0};
  const OutOfRound::Fit oval = OutOfRound::fit(points, settled);
  EXPECT_LT((oval.circle.center - kCenter).norm(), 0.04 * kRadius);
  EXPECT_LT(oval.misfit_px, 0.01 * kRadius);
  for (int i = 0; i < kOutlinePoints; ++i) {
    const Eigen::Vector2d d = points.col(i) - oval.circle.center;
    EXPECT_NEAR(oval.circle.radius + oval.shape.at(d.normalized()), d.norm(), 0.04 * kRadius);
  }
  EXPECT_EQ(OutOfRound::fit(points, settled, 0).circle.center, settled.center);
}

TEST(RestGeometry, ANeedleEntersAnOvalWhereItsOutlineIs) {
  RestGeometry rest;
  rest.learn(kCenter, kRadius, 0.0, OutOfRound::of(outline(1.12, 0.0), kCircle), 0.0);
  // Turned by 0.5 since, and pushed along its long axis.
  const Eigen::Vector2d direction = -toward(0.5);
  const Eigen::Vector2d entry = rest.entry_point(kCenter, kCenter + 100.0 * toward(0.5), direction, 0.5);
  EXPECT_NEAR((entry - kCenter).norm(), ellipse_at(1.12, 0.0), 0.1);
  EXPECT_NEAR((entry - kCenter).normalized().dot(toward(0.5)), 1.0, 1e-9);
  // Beside the centre the point lies on the needle's line and on the outline.
  const Eigen::Vector2d side(-direction.y(), direction.x());
  const Eigen::Vector2d beside =
      rest.entry_point(kCenter, kCenter + 100.0 * toward(0.5) + 20.0 * side, direction, 0.5) - kCenter;
  EXPECT_NEAR(beside.dot(side), 20.0, 1e-9);
  EXPECT_NEAR(beside.norm(), ellipse_at(1.12, std::atan2(beside.y(), beside.x()) - 0.5), 0.15);
}

/// A cell that lies on the zona: 0.3 rad to both sides of 0.6 rad, `height_px` high.
double cumulus_px(int i, double height_px) {
  const double angle = 2.0 * std::numbers::pi * i / kOutlinePoints;
  return height_px * std::max(0.0, 1.0 - std::abs(angle - 0.6) / 0.3);
}

TEST(OutOfRound, ABumpIsWhatBulgesOutOfAnOvalOverASmallPart) {
  for (const double height_px : {8.0, 12.0, 16.0}) {
    Eigen::Matrix2Xd points = outline(1.08, 0.4);
    for (int i = 0; i < kOutlinePoints; ++i) {
      const Eigen::Vector2d d = points.col(i) - kCenter;
      points.col(i) += cumulus_px(i, height_px) * d.normalized();
    }
    const Eigen::VectorXd bumps = OutOfRound::bumps(points, kCircle);
    EXPECT_GT(bumps.maxCoeff(), 0.8 * height_px);
    for (int i = 0; i < kOutlinePoints; ++i) {
      if (cumulus_px(i, 1.0) > 0.0) continue;
      EXPECT_LT(bumps[i], OutOfRound::kBump_ratio * kRadius) << i;
    }
  }
}

// Two groups of such cells, over a third of the outline.
TEST(OutOfRound, BumpsMayTakeAThirdOfTheOutline) {
  constexpr double kHeight_px = 10.0;
  Eigen::Matrix2Xd points = outline(1.05, 0.4);
  const auto is_bump = [](int i) { return (i >= 20 && i < 56) || (i >= 110 && i < 138); };
  for (int i = 0; i < kOutlinePoints; ++i)
    if (is_bump(i)) points.col(i) += kHeight_px * (points.col(i) - kCenter).normalized();
  const Eigen::VectorXd bumps = OutOfRound::bumps(points, kCircle);
  for (int i = 0; i < kOutlinePoints; ++i) {
    if (is_bump(i)) EXPECT_GT(bumps[i], OutOfRound::kBump_ratio * kRadius) << i;
    if (!is_bump(i)) EXPECT_LT(bumps[i], OutOfRound::kBump_ratio * kRadius) << i;
  }
}

TEST(OutOfRound, AnOvalAndNoiseHaveNoBumps) {
  for (const Eigen::Matrix2Xd& points : {outline(1.12, 0.4), outline(1.05, 0.0, 0.4)})
    EXPECT_LT(OutOfRound::bumps(points, kCircle).maxCoeff(), OutOfRound::kBump_ratio * kRadius);
}

}  // namespace
}  // namespace pellucida
