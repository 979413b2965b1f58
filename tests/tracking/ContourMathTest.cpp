#include "ContourMath.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace pellucida {
namespace {

constexpr double kPi = std::numbers::pi;

Eigen::Matrix2Xd ellipse(double a, double b, Eigen::Index count, const Eigen::Vector2d& center = {0.0, 0.0}) {
  Eigen::Matrix2Xd points(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    points.col(i) = center + Eigen::Vector2d(a * std::cos(t), b * std::sin(t));
  }
  return points;
}

// A star-shaped contour with a random smooth outline, radius about 50.
Eigen::Matrix2Xd random_contour(std::mt19937& random, Eigen::Index count) {
  std::uniform_real_distribution<double> amplitude(-3.0, 3.0), phase(0.0, 2.0 * kPi);
  double a[5], p[5];
  for (int k = 0; k < 5; ++k) {
    a[k] = amplitude(random);
    p[k] = phase(random);
  }
  Eigen::Matrix2Xd points(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    double r = 50.0;
    for (int k = 0; k < 5; ++k) r += a[k] * std::cos((k + 1) * t + p[k]);
    points.col(i) = Eigen::Vector2d(100.0 + r * std::cos(t), 80.0 + r * std::sin(t));
  }
  return points;
}

TEST(ContourMath, AreaAndPerimeterOfACircleFollowTheClosedForm) {
  for (const Eigen::Index n : {64, 256, 1024}) {
    const Eigen::Matrix2Xd circle = ellipse(30.0, 30.0, n, {1000.0, -500.0});
    // An inscribed polygon: n/2 r^2 sin(2 pi / n), 2 n r sin(pi / n).
    EXPECT_NEAR(contour::signed_area(circle), 0.5 * n * 900.0 * std::sin(2.0 * kPi / n), 1e-6);
    EXPECT_NEAR(contour::arc_length(circle), 2.0 * n * 30.0 * std::sin(kPi / n), 1e-8);
  }
}

TEST(ContourMath, ReversalTurnsTheSignAndOrientationTurnsItBack) {
  const Eigen::Matrix2Xd forward = ellipse(20.0, 10.0, 100);
  const Eigen::Matrix2Xd backward = forward.rowwise().reverse();
  EXPECT_NEAR(contour::signed_area(forward), -contour::signed_area(backward), 1e-9);
  EXPECT_GT(contour::signed_area(contour::positively_oriented(backward)), 0.0);
}

TEST(ContourMath, CentroidMovesWithTheContour) {
  const Eigen::Vector2d shift(1e4, -3e3);
  std::mt19937 random(3);
  const Eigen::Matrix2Xd contour = random_contour(random, 200);
  const Eigen::Matrix2Xd moved = contour.colwise() + shift;
  EXPECT_LT((contour::centroid(moved) - contour::centroid(contour) - shift).norm(), 1e-6);
  EXPECT_LT((contour::centroid(ellipse(20.0, 10.0, 64, {5.0, 7.0})) - Eigen::Vector2d(5.0, 7.0)).norm(), 1e-9);
}

TEST(ContourMath, ResamplingSpacesEvenlyAndKeepsTheShape) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Eigen::Matrix2Xd fine = random_contour(random, 800);
    const Eigen::Matrix2Xd even = contour::resample(fine, 200, 17.0 * seed);
    ASSERT_EQ(even.cols(), 200);
    double shortest = 1e9, longest = 0.0;
    for (Eigen::Index i = 0; i < even.cols(); ++i) {
      const double edge = (even.col((i + 1) % 200) - even.col(i)).norm();
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
      EXPECT_LT(contour::distance_to(fine, even.col(i)), 1e-9);
    }
    EXPECT_LT(longest / shortest, 1.0008);
    EXPECT_NEAR(contour::signed_area(even) / contour::signed_area(fine), 1.0, 3.5e-4);
  }
}

TEST(ContourMath, ResamplingStartsWhereItIsAsked) {
  Eigen::Matrix2Xd square(2, 4);
  square << 0, 10, 10, 0, 0, 0, 10, 10;
  const Eigen::Matrix2Xd points = contour::resample(square, 4, 15.0);
  EXPECT_LT((points.col(0) - Eigen::Vector2d(10.0, 5.0)).norm(), 1e-12);
  EXPECT_LT((points.col(3) - Eigen::Vector2d(5.0, 0.0)).norm(), 1e-12);
  // A start beyond one turn, and before the first point, wraps.
  EXPECT_LT((contour::resample(square, 4, -25.0).col(0) - points.col(0)).norm(), 1e-12);
}

TEST(ContourMath, NormalsOfACirclePointOutwards) {
  const Eigen::Matrix2Xd circle = ellipse(12.0, 12.0, 90);
  const Eigen::Matrix2Xd normals = contour::outward_normals(circle);
  for (Eigen::Index i = 0; i < circle.cols(); ++i) EXPECT_NEAR(normals.col(i).dot(circle.col(i)), 12.0, 1e-9);
}

TEST(ContourMath, SelfIntersectionIsSeenAndNotInvented) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 random(seed);
    Eigen::Matrix2Xd contour = random_contour(random, 96);
    EXPECT_FALSE(contour::self_intersects(contour)) << "seed " << seed;
    // Two points far apart change places: that must cross.
    const Eigen::Vector2d kept = contour.col(10);
    contour.col(10) = contour.col(40);
    contour.col(40) = kept;
    EXPECT_TRUE(contour::self_intersects(contour)) << "seed " << seed;
  }
}

TEST(ContourMath, RayMeetsTheOutermostCrossing) {
  const Eigen::Matrix2Xd circle = ellipse(10.0, 10.0, 400);
  const double quarter = contour::ray_crossing_arc(circle, {0.0, 0.0}, Eigen::Vector2d::UnitY());
  EXPECT_NEAR(quarter, contour::arc_length(circle) / 4.0, 1e-6);
  EXPECT_LT(contour::ray_crossing_arc(circle, {30.0, 0.0}, Eigen::Vector2d::UnitX()), 0.0);
}

TEST(ContourMath, ContainsAgreesWithTheRadius) {
  const Eigen::Matrix2Xd circle = ellipse(10.0, 10.0, 720);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-15.0, 15.0);
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector2d p(place(random), place(random));
    if (std::abs(p.norm() - 10.0) < 0.01) continue;
    EXPECT_EQ(contour::contains(circle, p), p.norm() < 10.0);
  }
}

TEST(ContourMath, CircleFitIgnoresADimpleAndNoise) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.2);
    std::uniform_real_distribution<double> angle(0.0, 2.0 * kPi);
    const double dimple = angle(random);
    Eigen::Matrix2Xd points = ellipse(60.0, 60.0, 200, {300.0, 200.0});
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Vector2d d = points.col(i) - Eigen::Vector2d(300.0, 200.0);
      const double off = std::remainder(std::atan2(d.y(), d.x()) - dimple, 2.0 * kPi);
      const double depth = std::abs(off) < 0.6 ? 30.0 * std::cos(off / 0.6 * kPi / 2.0) : 0.0;
      points.col(i) -= d.normalized() * (depth + noise(random));
    }
    const contour::Circle circle = contour::fit_circle(points, 3.0);
    EXPECT_LT((circle.center - Eigen::Vector2d(300.0, 200.0)).norm(), 0.23) << "seed " << seed;
    EXPECT_NEAR(circle.radius, 60.0, 0.13) << "seed " << seed;
    EXPECT_GT(circle.inlier_ratio, 0.75);
  }
}

TEST(ContourMath, EmptyAndTinyContoursAreHarmless) {
  const Eigen::Matrix2Xd none(2, 0), one = Eigen::Matrix2Xd::Zero(2, 1);
  EXPECT_EQ(contour::signed_area(none), 0.0);
  EXPECT_EQ(contour::arc_length(one), 0.0);
  EXPECT_EQ(contour::resample(one, 10).cols(), 1);
  EXPECT_FALSE(contour::contains(none, {0.0, 0.0}));
  EXPECT_EQ(contour::fit_circle(one, 1.0).radius, 0.0);
}

}  // namespace
}  // namespace pellucida
