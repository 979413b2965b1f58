// Every energy term of the model: gradient and Hessian against finite differences, invariance, balance.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>

#include "TestProfiles.h"
#include "pellucida/mechanics/MembraneModel.h"

namespace pellucida {
namespace {

using testing::coarse_profile;
using testing::shaken;

class Terms : public ::testing::TestWithParam<unsigned> {
 protected:
  Terms()
      : model_(coarse_profile(), setup_for_configuration(coarse_profile(), 2)),
        hessian_(model_.energy().node_count(), model_.energy().coupled_nodes()) {
    model_.energy().bind(&hessian_);
    model_.set_depth(5.0);
    x_um_ = shaken(model_.rest().points_um, 1.2, GetParam());
  }

  /// Compares a term's derivatives with central differences, in some coordinates.
  template <class Term>
  void expect_derivatives(const Term& term) {
    const Eigen::Index n = x_um_.cols();
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, n);
    hessian_.set_zero();
    term.add(x_um_, &gradient, &hessian_);
    const Eigen::MatrixXd lower = hessian_.sparse();
    Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
    if constexpr (requires { term.rank_one_factor(); }) {
      const Eigen::Matrix3Xd slope = term.gradient_of_volume(x_um_);
      const Eigen::Map<const Eigen::VectorXd> g(slope.data(), slope.size());
      full += term.rank_one_factor() * g * g.transpose();
    }

    constexpr double kStep = 1e-5;
    double gradient_error = 0.0, gradient_size = 0.0, hessian_error = 0.0, hessian_size = 0.0;
    std::mt19937 generator(GetParam() + 100);
    for (int trial = 0; trial < 60; ++trial) {
      const auto k = static_cast<Eigen::Index>(generator() % static_cast<unsigned>(3 * n));
      Eigen::Matrix3Xd above = x_um_, below = x_um_;
      above.data()[k] += kStep;
      below.data()[k] -= kStep;
      Eigen::Matrix3Xd gradient_above = Eigen::Matrix3Xd::Zero(3, n), gradient_below = Eigen::Matrix3Xd::Zero(3, n);
      const double slope =
          (term.add(above, &gradient_above, nullptr) - term.add(below, &gradient_below, nullptr)) / (2.0 * kStep);
      gradient_error = std::max(gradient_error, std::abs(slope - gradient.data()[k]));
      gradient_size = std::max(gradient_size, std::abs(slope));
      const Eigen::Matrix3Xd column = (gradient_above - gradient_below) / (2.0 * kStep);
      const Eigen::Map<const Eigen::VectorXd> flat(column.data(), column.size());
      hessian_error = std::max(hessian_error, (flat - full.col(k)).cwiseAbs().maxCoeff());
      hessian_size = std::max(hessian_size, flat.cwiseAbs().maxCoeff());
    }
    ASSERT_GT(hessian_size, 0.0);
    EXPECT_LT(gradient_error, 1e-6 * std::max(gradient_size, 1e-3));
    EXPECT_LT(hessian_error, 1e-6 * hessian_size);
  }

  /// A term of the membrane alone knows nothing of where it is: same energy after a rigid motion, no net force, no net
  /// moment.
  template <class Term>
  void expect_internal(const Term& term) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.83, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
    const Eigen::Matrix3Xd moved = (turn * x_um_).colwise() + Eigen::Vector3d(12.0, -7.0, 30.0);
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
    Eigen::Matrix3Xd moved_gradient = gradient;
    const double energy = term.add(x_um_, &gradient, nullptr);
    const double moved_energy = term.add(moved, &moved_gradient, nullptr);
    ASSERT_GT(energy, 0.0);
    EXPECT_NEAR(moved_energy, energy, 1e-9 * energy);
    const double size = gradient.norm();
    EXPECT_LT((moved_gradient - turn * gradient).norm(), 1e-8 * size);

    EXPECT_LT(gradient.rowwise().sum().norm(), 1e-10 * size);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index n = 0; n < x_um_.cols(); ++n) {
      const Eigen::Vector3d x = x_um_.col(n), g = gradient.col(n);
      moment += x.cross(g);
    }
    EXPECT_LT(moment.norm(), 1e-8 * size * 50.0);
  }

  MembraneModel model_;
  BlockMatrix hessian_;
  Eigen::Matrix3Xd x_um_;
};

TEST_P(Terms, SpringDerivativesMatchFiniteDifferences) {
  expect_derivatives(model_.springs());
}
TEST_P(Terms, HingeDerivativesMatchFiniteDifferences) {
  expect_derivatives(model_.hinges());
}
TEST_P(Terms, VolumeDerivativesMatchFiniteDifferences) {
  expect_derivatives(model_.volume());
}
TEST_P(Terms, TipDerivativesMatchFiniteDifferences) {
  expect_derivatives(model_.tip());
}
TEST_P(Terms, HolderDerivativesMatchFiniteDifferences) {
  expect_derivatives(model_.holder());
}

TEST_P(Terms, SpringsAreInternal) {
  expect_internal(model_.springs());
}
TEST_P(Terms, HingesAreInternal) {
  expect_internal(model_.hinges());
}
TEST_P(Terms, VolumeIsInternal) {
  expect_internal(model_.volume());
}

TEST_P(Terms, DampersNeverAddEnergyAndKeepMomentum) {
  const Eigen::Matrix3Xd velocity = shaken(Eigen::Matrix3Xd::Zero(3, x_um_.cols()), 25.0, GetParam() + 7);
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
  model_.springs().add_damping(x_um_, velocity, 2e-3, force);
  EXPECT_LT((force.array() * velocity.array()).sum(), 0.0);
  EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());

  // A rigid translation costs nothing; neither does a rigid turn, which stretches no connector.
  const Eigen::Matrix3Xd drift = Eigen::Vector3d(3.0, -2.0, 1.0).replicate(1, x_um_.cols());
  force.setZero();
  model_.springs().add_damping(x_um_, drift, 2e-3, force);
  EXPECT_LT(force.norm(), 1e-12);
  Eigen::Matrix3Xd turning(3, x_um_.cols());
  for (Eigen::Index n = 0; n < x_um_.cols(); ++n) {
    const Eigen::Vector3d x = x_um_.col(n);
    turning.col(n) = Eigen::Vector3d(0.2, 0.7, -0.4).cross(x);
  }
  model_.springs().add_damping(x_um_, turning, 2e-3, force);
  EXPECT_LT(force.norm(), 1e-10);
}

TEST_P(Terms, TensionOfAnInflatedSphereIsTheLaplaceTension) {
  // Springs alone carry a pressure P when the tension is P R / 2: the work of a small growth dR is P 4 pi R^2 dR.
  const double growth = 0.02 + 0.01 * GetParam();
  const Eigen::Matrix3Xd grown = (1.0 + growth) * model_.rest().points_um;
  const Eigen::Matrix3Xi& triangles = model_.rest().triangles;
  const Eigen::VectorXd areas = node_areas_um2(grown, triangles);
  const Eigen::VectorXd tension = model_.springs().tension_uN_per_um(grown, areas);
  constexpr double kStep = 1e-5;
  const double work = (model_.springs().add(grown * (1.0 + kStep), nullptr, nullptr) -
                       model_.springs().add(grown * (1.0 - kStep), nullptr, nullptr)) /
                      (2.0 * kStep);
  // Scaling by (1 + s) does work 2 s T dA: the mean tension over the area is work / (2 area).
  EXPECT_NEAR(tension.dot(areas) / areas.sum(), work / (2.0 * areas.sum()), 1e-6 * work / areas.sum());
  EXPECT_GT(tension.minCoeff(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Terms, ::testing::Values(1u, 2u, 3u));

TEST(SpringTerm, FollowsTheLawOfEquationOne) {
  // One pair of triangles folded into a closed tetrahedron: connector 0-1 stretched alone.
  TriangleMesh mesh;
  mesh.points_um.resize(3, 4);
  mesh.points_um << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1, 1, 2, 3, 3, 2, 3, 1, 2;
  const auto pairs = triangle_pairs(mesh.triangles);
  ASSERT_EQ(pairs.size(), 6u);
  const double k2 = 0.7, k1 = -0.2;
  const SpringTerm springs(mesh, pairs, {Eigen::VectorXd::Constant(4, k2), Eigen::VectorXd::Constant(4, k1)});

  // Scaling by 1 + e stretches all connectors by e: f = k (L/|p| - 1) p with k = A / L^2 (K2 + K1 e^2). A tetrahedron's
  // edge is an edge once and an opposite link once, so two connectors lie on it, of (a1 + a2) / 6 each.
  const double e = 0.15;
  const double length = 2.0 * std::sqrt(2.0);
  const double triangle_area = std::sqrt(3.0) / 4.0 * length * length;
  const double k = 2.0 * (2.0 * triangle_area / 6.0) / (length * length) * (k2 + k1 * e * e);
  const Eigen::Matrix3Xd x = (1.0 + e) * mesh.points_um;
  Eigen::Vector3d expected = Eigen::Vector3d::Zero();
  for (int j = 1; j < 4; ++j) {
    const Eigen::Vector3d p = x.col(0) - x.col(j);
    expected += k * (length / p.norm() - 1.0) * p;
  }
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 4);
  springs.add(x, &gradient, nullptr);
  EXPECT_LT((-gradient.col(0) - expected).norm(), 1e-12);
  EXPECT_GT(expected.norm(), 0.01);
}

TEST(HingeTerm, AngleIsPositiveOnAConvexFoldAndTheEnergyIsQuadratic) {
  const auto angle = [](double fold) {
    return hinge_angle_rad({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 1, 0),
                            Eigen::Vector3d(-std::cos(fold / 2), 0.5, -std::sin(fold / 2)),
                            Eigen::Vector3d(std::cos(fold / 2), 0.5, -std::sin(fold / 2))});
  };
  for (const double fold : {-2.5, -0.4, 0.0, 0.3, 1.2, 2.8}) EXPECT_NEAR(angle(fold), fold, 1e-12);
}

}  // namespace
}  // namespace pellucida
