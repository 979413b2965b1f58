#include "NeoHookeanTerm.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/SphereMesh.h"

namespace pellucida {
namespace {

constexpr double kModulus = 0.0179, kThickness_um = 5.0;

/// A flat strip of two right triangles, 3 um along x and 2 um along y.
TriangleMesh flat_strip() {
  TriangleMesh mesh;
  mesh.points_um.resize(3, 4);
  mesh.points_um << 0.0, 3.0, 3.0, 0.0,  //
      0.0, 0.0, 2.0, 2.0,                //
      0.0, 0.0, 0.0, 0.0;
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 0, 1, 2, 2, 3;
  return mesh;
}

Eigen::Matrix3Xd stretched(const TriangleMesh& mesh, double along_x, double along_y) {
  return Eigen::Vector3d(along_x, along_y, 1.0).asDiagonal() * mesh.points_um;
}

class NeoHookean : public ::testing::TestWithParam<double> {};

TEST_P(NeoHookean, DerivativesAreThoseOfTheEnergy) {
  const TriangleMesh sphere = make_sphere_mesh(50.0, {2, 1.3});
  NeoHookeanTerm term(sphere, kModulus, GetParam(), kThickness_um);
  std::vector<std::pair<int, int>> pairs;
  term.append_coupled_nodes(pairs);
  BlockMatrix matrix(static_cast<int>(sphere.points_um.cols()), pairs);
  term.bind(matrix);

  // A shape with stretches of some tens of per cent.
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shake(-4.0, 4.0);
  Eigen::Matrix3Xd x = 1.1 * sphere.points_um;
  for (Eigen::Index k = 0; k < x.size(); ++k) x.data()[k] += shake(generator);

  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
  term.add(x, &gradient, &matrix);
  const Eigen::MatrixXd lower = matrix.sparse();
  const Eigen::MatrixXd hessian = lower.selfadjointView<Eigen::Lower>();
  constexpr double kStep = 1e-4;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Eigen::Matrix3Xd above = x, below = x;
    above.data()[k] += kStep;
    below.data()[k] -= kStep;
    Eigen::Matrix3Xd up = Eigen::Matrix3Xd::Zero(3, x.cols()), down = up;
    const double slope = (term.add(above, &up, nullptr) - term.add(below, &down, nullptr)) / (2.0 * kStep);
    EXPECT_NEAR(gradient.data()[k], slope, 1e-8 * gradient.cwiseAbs().maxCoeff());
    const Eigen::Matrix3Xd column = (up - down) / (2.0 * kStep);
    const Eigen::Map<const Eigen::VectorXd> flat(column.data(), column.size());
    EXPECT_LT((hessian.col(k) - flat).cwiseAbs().maxCoeff(), 1e-8 * hessian.cwiseAbs().maxCoeff());
  }
}

TEST_P(NeoHookean, RigidMotionCostsNothing) {
  const TriangleMesh sphere = make_sphere_mesh(50.0, {3, 1.0});
  const NeoHookeanTerm term(sphere, kModulus, GetParam(), kThickness_um);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  const Eigen::Matrix3Xd moved = (turn * sphere.points_um).colwise() + Eigen::Vector3d(3.0, 20.0, -7.0);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, moved.cols());
  EXPECT_NEAR(term.add(moved, &gradient, nullptr), 0.0, 1e-11);
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-12);

  // A stretched shape's energy doesn't change with the place it is seen from; its forces turn with it.
  const Eigen::Matrix3Xd stretched_shape = Eigen::Vector3d(1.2, 0.9, 1.05).asDiagonal() * sphere.points_um;
  const Eigen::Matrix3Xd seen = (turn * stretched_shape).colwise() + Eigen::Vector3d(3.0, 20.0, -7.0);
  Eigen::Matrix3Xd here = Eigen::Matrix3Xd::Zero(3, moved.cols()), there = here;
  const double energy = term.add(stretched_shape, &here, nullptr);
  EXPECT_NEAR(term.add(seen, &there, nullptr), energy, 1e-10 * energy);
  EXPECT_LT((turn * here - there).cwiseAbs().maxCoeff(), 1e-11);
}

TEST_P(NeoHookean, HasYoungsModulusAndPoissonsRatioAtSmallStrain) {
  // Energy per area of plane stress: E h / (2 (1 - nu^2)) (ex^2 + ey^2 + 2 nu ex ey).
  const TriangleMesh strip = flat_strip();
  const double nu = GetParam();
  const NeoHookeanTerm term(strip, kModulus, nu, kThickness_um);
  for (const auto& [ex, ey] : {std::pair{1e-3, 0.0}, {0.0, 1e-3}, {1e-3, 1e-3}, {1e-3, -1e-3}, {1e-3, -nu * 1e-3}}) {
    const double expected =
        6.0 * kModulus * kThickness_um / (2.0 * (1.0 - nu * nu)) * (ex * ex + ey * ey + 2.0 * nu * ex * ey);
    EXPECT_NEAR(term.add(stretched(strip, 1.0 + ex, 1.0 + ey), nullptr, nullptr), expected, 5e-3 * expected);
  }
}

INSTANTIATE_TEST_SUITE_P(PoissonRatios, NeoHookean, ::testing::Values(0.5, 0.45, 0.3, 0.05));

// Treloar: under a pull along x the other two stretches are l^-1/2; nominal stress mu (l - 1/l^2).
TEST(NeoHookeanIncompressible, PullsAsTreloarSays) {
  const TriangleMesh strip = flat_strip();
  const NeoHookeanTerm term(strip, kModulus, 0.5, kThickness_um);
  for (const double stretch : {0.7, 1.2, 1.66, 3.0}) {
    const Eigen::Matrix3Xd x = stretched(strip, stretch, 1.0 / std::sqrt(stretch));
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 4);
    term.add(x, &gradient, nullptr);
    const double pull = kModulus / 3.0 * (stretch - 1.0 / (stretch * stretch)) * 2.0 * kThickness_um;
    EXPECT_NEAR(gradient(0, 1) + gradient(0, 2), pull, 1e-9);
    EXPECT_NEAR(gradient.row(1).cwiseAbs().maxCoeff(), 0.0, 1e-9);  // free at the sides
  }
}

TEST(NeoHookeanStretches, ArePrincipalOnes) {
  const TriangleMesh strip = flat_strip();
  const NeoHookeanTerm term(strip, kModulus, 0.5, kThickness_um);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 1.0, 1.0).normalized()).toRotationMatrix();
  const Eigen::Matrix2Xd found = term.principal_stretches(turn * stretched(strip, 0.8, 1.5));
  for (Eigen::Index t = 0; t < 2; ++t) {
    EXPECT_NEAR(found(0, t), 1.5, 1e-12);
    EXPECT_NEAR(found(1, t), 0.8, 1e-12);
  }
}

TEST(NeoHookeanArguments, OutOfRangeAreRefused) {
  EXPECT_THROW(NeoHookeanTerm(flat_strip(), 0.0, 0.5, 5.0), UsageError);
  EXPECT_THROW(NeoHookeanTerm(flat_strip(), 1.0, 0.0, 5.0), UsageError);
  EXPECT_THROW(NeoHookeanTerm(flat_strip(), 1.0, 0.51, 5.0), UsageError);
  EXPECT_THROW(NeoHookeanTerm(flat_strip(), 1.0, 0.5, 0.0), UsageError);
  TriangleMesh flat = flat_strip();
  flat.points_um.col(1) = flat.points_um.col(0);
  EXPECT_THROW(NeoHookeanTerm(flat, 1.0, 0.5, 5.0), UsageError);
}

}  // namespace
}  // namespace pellucida
