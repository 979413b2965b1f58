#include "GradedSphereMesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kRadius_um = 50.0;

/// 1.5 um about +z, growing to 7 um.
double graded(const Eigen::Vector3d& p) {
  return std::min(7.0, 1.5 + 0.13 * std::max(0.0, (p - Eigen::Vector3d(0.0, 0.0, kRadius_um)).norm() - 5.0));
}

class GradedSphereMesh : public ::testing::Test {
 protected:
  GradedSphere sphere_ = make_graded_sphere_mesh(kRadius_um, 0.2, graded);
};

TEST_F(GradedSphereMesh, IsClosedOutwardAndOnTheSphere) {
  EXPECT_NO_THROW(triangle_pairs(sphere_.mesh.triangles));
  EXPECT_EQ(sphere_.mesh.triangles.cols(), 2 * sphere_.mesh.points_um.cols() - 4);  // Euler
  EXPECT_NEAR(sphere_.mesh.points_um.colwise().norm().minCoeff(), kRadius_um, 1e-9);
  EXPECT_NEAR(sphere_.mesh.points_um.colwise().norm().maxCoeff(), kRadius_um, 1e-9);
  EXPECT_NEAR(enclosed_volume_um3(sphere_.mesh.points_um, sphere_.mesh.triangles),
              4.0 / 3.0 * std::numbers::pi * std::pow(kRadius_um, 3), 0.01 * 523599.0);
}

TEST_F(GradedSphereMesh, KeepsTheEdgeLengthsAskedFor) {
  double sum = 0.0, shortest = 1e9, longest = 0.0;
  const auto pairs = triangle_pairs(sphere_.mesh.triangles);
  for (const auto& pair : pairs) {
    const Eigen::Vector3d a = sphere_.mesh.points_um.col(pair.a), b = sphere_.mesh.points_um.col(pair.b);
    const double ratio = (a - b).norm() / graded(kRadius_um * (a + b).normalized());
    sum += ratio;
    shortest = std::min(shortest, ratio);
    longest = std::max(longest, ratio);
  }
  EXPECT_NEAR(sum / static_cast<double>(pairs.size()), 1.0, 0.02);
  EXPECT_GT(shortest, 0.5);
  EXPECT_LT(longest, 1.7);
}

TEST_F(GradedSphereMesh, TrianglesAreCloseToEquilateral) {
  double smallest = std::numbers::pi;
  for (Eigen::Index t = 0; t < sphere_.mesh.triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = sphere_.mesh.points_um.col(sphere_.mesh.triangles(k, t));
      const Eigen::Vector3d b = sphere_.mesh.points_um.col(sphere_.mesh.triangles((k + 1) % 3, t));
      const Eigen::Vector3d c = sphere_.mesh.points_um.col(sphere_.mesh.triangles((k + 2) % 3, t));
      smallest = std::min(smallest, std::acos((b - a).normalized().dot((c - a).normalized())));
    }
  }
  EXPECT_GT(smallest, 25.0 * std::numbers::pi / 180.0);
}

TEST_F(GradedSphereMesh, ThePlaneOfTheSectionIsAMirror) {
  // The section's nodes first, round from the angle asked for; then one half and its image.
  const int rim = sphere_.meridian_count;
  const auto inner = (sphere_.mesh.points_um.cols() - rim) / 2;
  EXPECT_NEAR(std::atan2(sphere_.mesh.points_um(0, 0), sphere_.mesh.points_um(2, 0)), 0.2, 1e-12);
  for (int n = 0; n < rim; ++n) EXPECT_EQ(sphere_.mesh.points_um(1, n), 0.0);
  for (Eigen::Index n = rim; n < rim + inner; ++n) {
    EXPECT_GT(sphere_.mesh.points_um(1, n), 0.0);
    const Eigen::Vector3d image = sphere_.mesh.points_um.col(n).cwiseProduct(Eigen::Vector3d(1.0, -1.0, 1.0));
    EXPECT_EQ(sphere_.mesh.points_um.col(n + inner), image);
  }
  for (int n = 0; n < rim; ++n) {
    const Eigen::Vector3d a = sphere_.mesh.points_um.col(n), b = sphere_.mesh.points_um.col((n + 1) % rim);
    EXPECT_GT(a.cross(b).y(), 0.0);  // from +z towards +x
  }
}

TEST_F(GradedSphereMesh, SameInputSameMesh) {
  const GradedSphere again = make_graded_sphere_mesh(kRadius_um, 0.2, graded);
  EXPECT_EQ(again.mesh.points_um, sphere_.mesh.points_um);
  EXPECT_EQ(again.mesh.triangles, sphere_.mesh.triangles);
}

TEST(GradedSphereMeshArguments, OutOfRangeAreRefused) {
  EXPECT_THROW(make_graded_sphere_mesh(0.0, 0.0, graded), UsageError);
  EXPECT_THROW(make_graded_sphere_mesh(50.0, 0.0, [](const Eigen::Vector3d&) { return 0.0; }), UsageError);
  EXPECT_THROW(make_graded_sphere_mesh(50.0, 0.0, [](const Eigen::Vector3d&) { return 1e-4; }), UsageError);
}

}  // namespace
}  // namespace pellucida
