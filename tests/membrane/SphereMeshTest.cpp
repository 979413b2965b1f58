#include "pellucida/membrane/SphereMesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/AttachmentTerm.h"

namespace pellucida {
namespace {

class SphereMesh : public ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(SphereMesh, IsClosedOutwardAndOnTheSphere) {
  const auto [frequency, grading] = GetParam();
  const TriangleMesh mesh = make_sphere_mesh(50.0, {frequency, grading});
  EXPECT_EQ(mesh.points_um.cols(), 10 * frequency * frequency + 2);
  EXPECT_EQ(mesh.triangles.cols(), 20 * frequency * frequency);
  EXPECT_EQ(triangle_pairs(mesh.triangles).size(), static_cast<std::size_t>(30 * frequency * frequency));
  EXPECT_LT((mesh.points_um.colwise().norm().array() - 50.0).abs().maxCoeff(), 1e-9);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3d a = mesh.points_um.col(mesh.triangles(0, t)), b = mesh.points_um.col(mesh.triangles(1, t)),
                          c = mesh.points_um.col(mesh.triangles(2, t));
    EXPECT_GT((b - a).cross(c - a).dot(a + b + c), 0.0);
  }
}

TEST_P(SphereMesh, HasNodesOnThePolesAndTwoMirrors) {
  const auto [frequency, grading] = GetParam();
  const TriangleMesh mesh = make_sphere_mesh(50.0, {frequency, grading});
  const auto nearest = [&](const Eigen::Vector3d& p) {
    return (mesh.points_um.colwise() - p).colwise().norm().minCoeff();
  };
  if (frequency % 2 == 0) {
    EXPECT_LT(nearest({0, 0, 50}), 1e-9);
    EXPECT_LT(nearest({0, 0, -50}), 1e-9);
  }
  for (Eigen::Index n = 0; n < mesh.points_um.cols(); ++n) {
    EXPECT_LT(nearest(mesh.points_um.col(n).cwiseProduct(Eigen::Vector3d(1, -1, 1))), 1e-9);
    EXPECT_LT(nearest(mesh.points_um.col(n).cwiseProduct(Eigen::Vector3d(-1, 1, 1))), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, SphereMesh,
                         ::testing::Combine(::testing::Values(1, 2, 8), ::testing::Values(1.0, 1.25, 2.0)));

TEST(SphereMeshSize, VolumeAndAreaApproachTheSphere) {
  const auto sphere_volume = 4.0 / 3.0 * std::numbers::pi * std::pow(50.0, 3);
  double before = 1.0;
  for (const int frequency : {4, 8, 16}) {
    const TriangleMesh mesh = make_sphere_mesh(50.0, {frequency, 1.0});
    const double error = 1.0 - enclosed_volume_um3(mesh.points_um, mesh.triangles) / sphere_volume;
    EXPECT_GT(error, 0.0);
    EXPECT_LT(error, 0.3 * before);
    before = error;
    EXPECT_NEAR(node_areas_um2(mesh.points_um, mesh.triangles).sum(),
                triangle_areas_um2(mesh.points_um, mesh.triangles).sum(), 1e-6);
  }
}

TEST(SphereMeshOptionsCheck, WrongOptionsAreUsageErrors) {
  EXPECT_THROW(make_sphere_mesh(0.0, {}), UsageError);
  EXPECT_THROW(make_sphere_mesh(50.0, {0, 1.0}), UsageError);
  EXPECT_THROW(make_sphere_mesh(50.0, {7, 0.0}), UsageError);
}

TEST(TrianglePairs, AnOpenSurfaceIsRefused) {
  TriangleMesh mesh = make_sphere_mesh(1.0, {2, 1.0});
  EXPECT_THROW(triangle_pairs(mesh.triangles.leftCols(mesh.triangles.cols() - 1)), Error);
  mesh.triangles.col(3).reverseInPlace();
  EXPECT_THROW(triangle_pairs(mesh.triangles), Error);
}

TEST(AttachmentWeights, CarryTheDensitysIntegralOnAnyMesh) {
  // Closed forms: tip kt pi a^2 / 2; the ring about kr 2 pi rho 4 w / 3, a little more for the sphere's slope.
  for (const int frequency : {5, 7, 12}) {
    const TriangleMesh mesh = make_sphere_mesh(50.0, {frequency, 1.25});
    const Eigen::VectorXd tip = tip_weights_uN_per_um(mesh, Eigen::Vector3d::UnitZ(), 5.0, 0.2);
    EXPECT_NEAR(tip.sum(), 0.2 * std::numbers::pi * 25.0 / 2.0, 1e-9);
    EXPECT_GE(tip.minCoeff(), 0.0);
    const Eigen::Vector3d direction(std::sin(0.7), 0.0, -std::cos(0.7));
    const Eigen::VectorXd holder = holder_weights_uN_per_um(mesh, direction, 17.5, 5.0, 0.1);
    const double flat_ring = 0.1 * 2.0 * std::numbers::pi * 17.5 * 4.0 * 5.0 / 3.0;
    EXPECT_GT(holder.sum(), flat_ring);
    EXPECT_LT(holder.sum(), 1.12 * flat_ring);
    // The ring's middle lies on the holder's axis.
    const Eigen::Vector3d middle = mesh.points_um * holder / holder.sum();
    EXPECT_LT(middle.cross(direction).norm(), 0.2);
    EXPECT_GT(middle.dot(direction), 45.0);
  }
}

}  // namespace
}  // namespace pellucida
