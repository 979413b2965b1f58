// How an outline runs about a needle's tip that pushes it in, on outlines made here.
#include "Dimple.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ContourMath.h"

namespace pellucida {
namespace {

constexpr double kRadius_px = 80.0, kWidth_px = 30.0;
const Eigen::Vector2d kCenter(210.0, 190.0), kDirection = Eigen::Vector2d(0.8, 0.6);  // of the needle
const Eigen::Vector2d kAcross(-kDirection.y(), kDirection.x());

// A round cell that a needle through its middle pushes in by `depth_px`.
Eigen::Matrix2Xd pushed_cell(double depth_px) {
  constexpr int kPoints = 200;
  Eigen::Matrix2Xd points(2, kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.3) / kPoints;
    const Eigen::Vector2d out(std::cos(angle), std::sin(angle));
    points.col(i) = kCenter + kRadius_px * out;
    const double across = out.dot(kAcross) * kRadius_px / kWidth_px;
    if (out.dot(kDirection) < 0.0) points.col(i) += depth_px * std::exp(-0.5 * across * across) * kDirection;
  }
  return points;
}

Eigen::Vector2d tip_at(double depth_px) {
  return kCenter + (depth_px - kRadius_px) * kDirection;
}

Dimple dimple_of(const Eigen::Matrix2Xd& outline, double tip_depth_px) {
  return Dimple::of(outline, kCenter, kRadius_px, tip_at(tip_depth_px), kDirection);
}

// Moves what lies between `from_px` and `to_px` beside the needle's line, on the needle's side, by `way_px`.
Eigen::Matrix2Xd with_moved(Eigen::Matrix2Xd outline, double from_px, double to_px, const Eigen::Vector2d& way_px) {
  for (Eigen::Index i = 0; i < outline.cols(); ++i) {
    const Eigen::Vector2d d = outline.col(i) - kCenter;
    if (d.dot(kDirection) < 0.0 && d.dot(kAcross) > from_px && d.dot(kAcross) < to_px) outline.col(i) += way_px;
  }
  return outline;
}

TEST(Dimple, OneThatANeedleMakesIsNotOdd) {
  for (const double depth_px : {0.0, 5.0, 20.0, 50.0})
    EXPECT_LT(dimple_of(pushed_cell(depth_px), depth_px).worst_px(), 0.5) << depth_px;
}

TEST(Dimple, SaysWhatIsOdd) {
  constexpr double kDepth_px = 50.0;
  const Eigen::Matrix2Xd outline = pushed_cell(kDepth_px);
  EXPECT_NEAR(dimple_of(with_moved(outline, 10.0, 20.0, -12.0 * kDirection), kDepth_px).notched_px, 8.0, 4.0);
  EXPECT_NEAR(dimple_of(with_moved(outline, 10.0, 20.0, 12.0 * kDirection), kDepth_px).notched_px, 8.0, 4.0);
  EXPECT_NEAR(dimple_of(with_moved(outline, 20.0, 30.0, -9.0 * kAcross), kDepth_px).folded_px, 7.0, 2.5);
  EXPECT_NEAR(dimple_of(outline, kDepth_px + 8.0).short_px, 8.0, 0.5);
  EXPECT_NEAR(dimple_of(with_moved(outline, 35.0, 45.0, -35.0 * kDirection), kDepth_px).raised_px, 9.0, 4.0);
}

TEST(Dimple, ANeedleBesideTheCellHasNone) {
  const Eigen::Vector2d beside = tip_at(0.0) + 2.0 * kRadius_px * kAcross;
  const Eigen::Matrix2Xd outline = pushed_cell(0.0);
  EXPECT_EQ(Dimple::of(outline, kCenter, kRadius_px, beside, kDirection).worst_px(), 0.0);
  EXPECT_EQ(with_smooth_dimple(outline, beside, kDirection, 20.0), outline);
}

TEST(Dimple, IsMadeSmoothAndEndsOnTheTip) {
  constexpr double kDepth_px = 25.0;
  const Eigen::Matrix2Xd truth = pushed_cell(kDepth_px);
  const Eigen::Matrix2Xd kinked = with_moved(truth, 10.0, 20.0, -15.0 * kDirection);
  const Eigen::Matrix2Xd smooth = with_smooth_dimple(kinked, tip_at(kDepth_px), kDirection, 30.0);
  EXPECT_GT((kinked - truth).colwise().norm().maxCoeff(), 14.0);
  for (Eigen::Index i = 0; i < smooth.cols(); ++i) EXPECT_LT(contour::distance_to(truth, smooth.col(i)), 3.0) << i;
  EXPECT_LT(dimple_of(smooth, kDepth_px).worst_px(), 0.5);
  EXPECT_LT(contour::distance_to(smooth, tip_at(kDepth_px)), 0.5);
}

}  // namespace
}  // namespace pellucida
