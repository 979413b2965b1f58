// Every energy term of the model: gradient and Hessian against finite differences, invariance, balance.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <memory>
#include <numbers>
#include <string>
#include <tuple>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/HingeTerm.h"
#include "pellucida/membrane/NormalObservationTerm.h"
#include "pellucida/membrane/SphereMesh.h"
#include "pellucida/membrane/SpringTerm.h"
#include "pellucida/membrane/VolumeTerm.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

using testing::shaken;

/// A surface of revolution as the reconstruction makes it: rings of `columns` nodes between two poles, an egg.
TriangleMesh revolved_mesh(int rings, int columns) {
  TriangleMesh mesh;
  mesh.points_um.resize(3, rings * columns + 2);
  mesh.triangles.resize(3, 2 * rings * columns);
  const int north = rings * columns, south = north + 1;
  mesh.points_um.col(north) << 0.0, 0.0, 52.0;
  mesh.points_um.col(south) << 0.0, 0.0, -48.0;
  int t = 0;
  for (int r = 0; r < rings; ++r) {
    const double theta = std::numbers::pi * (r + 1) / (rings + 1);
    for (int c = 0; c < columns; ++c) {
      const double phi = 2.0 * std::numbers::pi * c / columns;
      const double rho = 48.0 * std::sin(theta) * (1.0 + 0.05 * std::cos(theta));
      mesh.points_um.col(r * columns + c) << rho * std::cos(phi), rho * std::sin(phi), 2.0 + 50.0 * std::cos(theta);
      const int next = (c + 1) % columns;
      if (r == 0) mesh.triangles.col(t++) << north, c, next;
      if (r == rings - 1) {
        mesh.triangles.col(t++) << south, r * columns + next, r * columns + c;
      } else {
        mesh.triangles.col(t++) << r * columns + c, (r + 1) * columns + c, (r + 1) * columns + next;
        mesh.triangles.col(t++) << r * columns + c, (r + 1) * columns + next, r * columns + next;
      }
    }
  }
  return mesh;
}

TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.points_um.resize(3, 4);
  mesh.points_um << 30, -30, -30, 30, 30, -30, 30, -30, 30, 30, -30, -30;
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1, 2, 3, 1, 2, 1, 2, 3, 3;
  return mesh;
}

TriangleMesh mesh_named(const std::string& name) {
  if (name == "graded") return make_sphere_mesh(50.0, {4, 1.3});
  if (name == "uniform") return make_sphere_mesh(50.0, {5, 1.0});
  if (name == "revolved") return revolved_mesh(9, 14);
  return tetrahedron();
}

/// Every term on one mesh, with constants that differ from node to node, at a random shape.
class Terms : public ::testing::TestWithParam<std::tuple<std::string, unsigned>> {
 protected:
  Terms()
      : rest_(mesh_named(std::get<0>(GetParam()))),
        n_(rest_.points_um.cols()),
        pairs_(triangle_pairs(rest_.triangles)),
        springs_(rest_, pairs_, {varied(2.0), varied(-0.6)}),
        hinges_(rest_, pairs_, varied(1.5)),
        volume_(rest_, 16.0),
        tip_(rest_.points_um, varied(0.3).cwiseMax(0.2).array() - 0.2),
        energy_(static_cast<int>(n_), 0.7) {
    tip_.set_displacement({1.0, -2.0, 0.5});
    for (EnergyTerm* term : std::initializer_list<EnergyTerm*>{&springs_, &hinges_, &volume_, &tip_, &observation_}) {
      energy_.add_term(*term);
    }
    hessian_ = std::make_unique<BlockMatrix>(static_cast<int>(n_), energy_.coupled_nodes());
    energy_.bind(hessian_.get());
    x_um_ = shaken(rest_.points_um, 1.2, seed());
    std::vector<NormalObservationTerm::Observed> observed;
    for (int node = 0; node < n_; node += 2) {
      observed.push_back(
          {node, 1.02 * rest_.points_um.col(node), rest_.points_um.col(node).normalized(), 40.0 + node, 1e-3});
    }
    observation_.set(observed);
  }

  static unsigned seed() { return std::get<1>(GetParam()); }

  /// About `middle` on each node.
  Eigen::VectorXd varied(double middle) const {
    std::mt19937 generator(seed() + 40);
    std::uniform_real_distribution<double> ratio(0.5, 1.5);
    return Eigen::VectorXd::NullaryExpr(n_, [&] { return middle * ratio(generator); });
  }

  /// Compares a term's derivatives with central differences, in some coordinates.
  void expect_derivatives(const EnergyTerm& term) {
    const Eigen::Index n = x_um_.cols();
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, n);
    hessian_->set_zero();
    term.add(x_um_, &gradient, hessian_.get());
    const Eigen::MatrixXd lower = hessian_->sparse();
    Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
    if (term.has_rank_one()) {
      Eigen::Matrix3Xd slope;
      const double factor = term.rank_one(x_um_, slope);
      full += factor * slope.reshaped() * slope.reshaped().transpose();
    }

    constexpr double kStep = 1e-5;
    double gradient_error = 0.0, gradient_size = 0.0, hessian_error = 0.0, hessian_size = 0.0;
    std::mt19937 generator(seed() + 100);
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
    EXPECT_LT(gradient_error, 2e-7 * std::max(gradient_size, 1e-3));
    EXPECT_LT(hessian_error, 2e-7 * hessian_size);
  }

  /// A term of the membrane alone knows nothing of where it is: same energy after a rigid motion, no net force, no net
  /// moment.
  void expect_internal(const EnergyTerm& term) {
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

  TriangleMesh rest_;
  Eigen::Index n_;
  std::vector<TrianglePair> pairs_;
  SpringTerm springs_;
  HingeTerm hinges_;
  VolumeTerm volume_;
  AttachmentTerm tip_;
  NormalObservationTerm observation_;
  EnergySum energy_;
  std::unique_ptr<BlockMatrix> hessian_;
  Eigen::Matrix3Xd x_um_;
};

TEST_P(Terms, SpringDerivativesMatchFiniteDifferences) {
  expect_derivatives(springs_);
}
TEST_P(Terms, HingeDerivativesMatchFiniteDifferences) {
  expect_derivatives(hinges_);
}
TEST_P(Terms, VolumeDerivativesMatchFiniteDifferences) {
  expect_derivatives(volume_);
}
TEST_P(Terms, TipDerivativesMatchFiniteDifferences) {
  expect_derivatives(tip_);
}
TEST_P(Terms, ObservationDerivativesMatchFiniteDifferences) {
  expect_derivatives(observation_);
}
TEST_P(Terms, TheirSumIsWhatTheSolverSees) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, n_), apart = sum;
  const double energy = energy_.add(x_um_, &sum, nullptr);
  double parts = 0.0;
  for (const EnergyTerm* term : energy_.terms()) parts += term->add(x_um_, &apart, nullptr);
  EXPECT_DOUBLE_EQ(energy, parts);
  EXPECT_EQ(sum, apart);
  energy_.remove_term(volume_);
  EXPECT_NEAR(energy_.add(x_um_, nullptr, nullptr), energy - volume_.add(x_um_, nullptr, nullptr),
              1e-9 * std::abs(energy));
}

TEST_P(Terms, SpringsAreInternal) {
  expect_internal(springs_);
}
TEST_P(Terms, HingesAreInternal) {
  expect_internal(hinges_);
}
TEST_P(Terms, VolumeIsInternal) {
  expect_internal(volume_);
}

TEST_P(Terms, DampersNeverAddEnergyAndKeepMomentum) {
  const Eigen::Matrix3Xd velocity = shaken(Eigen::Matrix3Xd::Zero(3, x_um_.cols()), 25.0, seed() + 7);
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
  springs_.add_damping(x_um_, velocity, 2e-3, force);
  EXPECT_LT((force.array() * velocity.array()).sum(), 0.0);
  EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());

  // A rigid translation costs nothing; neither does a rigid turn, which stretches no connector.
  const Eigen::Matrix3Xd drift = Eigen::Vector3d(3.0, -2.0, 1.0).replicate(1, x_um_.cols());
  force.setZero();
  springs_.add_damping(x_um_, drift, 2e-3, force);
  EXPECT_LT(force.norm(), 1e-12);
  Eigen::Matrix3Xd turning(3, x_um_.cols());
  for (Eigen::Index n = 0; n < x_um_.cols(); ++n) {
    const Eigen::Vector3d x = x_um_.col(n);
    turning.col(n) = Eigen::Vector3d(0.2, 0.7, -0.4).cross(x);
  }
  springs_.add_damping(x_um_, turning, 2e-3, force);
  EXPECT_LT(force.norm(), 1e-10);
}

TEST_P(Terms, TensionOfAnInflatedSphereIsTheLaplaceTension) {
  // Springs alone carry a pressure P when the tension is P R / 2: the work of a small growth dR is P 4 pi R^2 dR.
  const double growth = 0.02 + 0.01 * seed();
  const Eigen::Matrix3Xd grown = (1.0 + growth) * rest_.points_um;
  const Eigen::Matrix3Xi& triangles = rest_.triangles;
  const Eigen::VectorXd areas = node_areas_um2(grown, triangles);
  const Eigen::VectorXd tension = springs_.tension_uN_per_um(grown, areas);
  constexpr double kStep = 1e-5;
  const double work =
      (springs_.add(grown * (1.0 + kStep), nullptr, nullptr) - springs_.add(grown * (1.0 - kStep), nullptr, nullptr)) /
      (2.0 * kStep);
  // Scaling by (1 + s) does work 2 s T dA: the mean tension over the area is work / (2 area).
  EXPECT_NEAR(tension.dot(areas) / areas.sum(), work / (2.0 * areas.sum()), 1e-6 * work / areas.sum());
  EXPECT_GT(tension.minCoeff(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Meshes, Terms,
                         ::testing::Combine(::testing::Values("graded", "uniform", "revolved", "tetrahedron"),
                                            ::testing::Values(1u, 2u)),
                         [](const auto& test) {
                           return std::get<0>(test.param) + "_" + std::to_string(std::get<1>(test.param));
                         });

TEST(NormalObservation, PullsAlongTheNormalAloneAndSaysHowFarOff) {
  NormalObservationTerm term;
  term.set({{0, {0, 0, 0}, {1, 0, 0}, 50.0, 2e-3}, {1, {5, 0, 0}, {0, 1, 0}, 150.0, 2e-3}});
  Eigen::Matrix3Xd x(3, 2);
  x << 0.4, 5.0, 3.0, 0.0, -2.0, 7.0;
  EXPECT_LT((term.force_uN(x) - Eigen::Vector3d(-0.04, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(term.residual_rms_um(x), 0.2, 1e-12);
  EXPECT_THROW(term.set({{0, {0, 0, 0}, {1, 1, 0}, 50.0, 2e-3}}), Error);
  BlockMatrix two(2, {});
  term.bind(two);
  EXPECT_THROW(term.set({{2, {0, 0, 0}, {1, 0, 0}, 50.0, 2e-3}}), Error);
}

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
