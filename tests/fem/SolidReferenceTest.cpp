// The solid of revolution: its terms' derivatives, balances, and the curves it is compared with.
#include "pellucida/fem/SolidReference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "SolidTerms.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/Table.h"
#include "pellucida/fem/ShellReference.h"
#include "support/SharedFolder.h"

namespace pellucida {
namespace {

AxisymmetricMesh small_mesh() {
  return make_axisymmetric_mesh(
      50.0, 8.0, [](double) { return 20.0; }, 2);
}

/// The mesh's points, shaken in their plane.
Eigen::Matrix3Xd shaken(const AxisymmetricMesh& mesh) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> shake(-0.4, 0.4);
  Eigen::Matrix3Xd x = 1.05 * mesh.points_um;
  for (Eigen::Index n = 0; n < x.cols(); ++n) x.col(n) += Eigen::Vector3d(shake(generator), 0.0, shake(generator));
  return x;
}

void expect_derivatives(EnergyTerm& term, const Eigen::Matrix3Xd& x) {
  std::vector<std::pair<int, int>> pairs;
  term.append_coupled_nodes(pairs);
  BlockMatrix matrix(static_cast<int>(x.cols()), pairs);
  term.bind(matrix);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
  term.add(x, &gradient, &matrix);
  const Eigen::MatrixXd lower = matrix.sparse();
  Eigen::MatrixXd hessian = lower.selfadjointView<Eigen::Lower>();
  if (term.has_rank_one()) {
    Eigen::Matrix3Xd direction;
    const double factor = term.rank_one(x, direction);
    const Eigen::Map<const Eigen::VectorXd> g(direction.data(), direction.size());
    hessian += factor * g * g.transpose();
  }
  constexpr double kStep = 1e-5;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (k % 3 == 1) continue;  // y, which nothing depends on
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

TEST(SolidTerms, DerivativesAreThoseOfTheEnergy) {
  const AxisymmetricMesh mesh = small_mesh();
  SolidTerm solid(mesh, 0.006, 0.6);
  expect_derivatives(solid, shaken(mesh));
  SolidTerm stiffening(mesh, 0.006, 0.6, 0.4);
  expect_derivatives(stiffening, shaken(mesh));
  RevolvedLiquidTerm liquid(mesh.points_um, mesh.inner, 2.0);
  expect_derivatives(liquid, shaken(mesh));
}

TEST(SolidTerms, VolumesAreThoseOfSpheres) {
  const AxisymmetricMesh mesh = make_axisymmetric_mesh(
      50.0, 8.0, [](double) { return 5.0; }, 2);
  const RevolvedLiquidTerm liquid(mesh.points_um, mesh.inner, 2.0);
  EXPECT_NEAR(liquid.rest_volume_um3(), 4.0 / 3.0 * std::numbers::pi * std::pow(46.0, 3), 0.27);
  // Swollen by a tenth: mu/2 (3 l^2 - 3 - 6 ln l) + lambda/2 (l^3 - 1)^2 in every part of the wall's volume.
  const SolidTerm solid(mesh, 0.006, 0.6);
  const double wall = 4.0 / 3.0 * std::numbers::pi * (std::pow(54.0, 3) - std::pow(46.0, 3));
  const double density = 0.5 * 0.006 * (3.0 * 1.21 - 3.0 - 6.0 * std::log(1.1)) + 0.3 * std::pow(1.331 - 1.0, 2);
  EXPECT_NEAR(solid.add(1.1 * mesh.points_um, nullptr, nullptr), density * wall, 7e-7 * density * wall);
  EXPECT_NEAR(solid.largest_volume_change(1.1 * mesh.points_um), 0.331, 1e-6);
  // With b: (exp(b (3 l^2 - 3)) - 1) / b in place of 3 l^2 - 3.
  const SolidTerm stiffening(mesh, 0.006, 0.6, 0.4);
  const double more = 0.5 * 0.006 * (std::expm1(0.4 * 0.63) / 0.4 - 0.63);
  EXPECT_NEAR(stiffening.add(1.1 * mesh.points_um, nullptr, nullptr), (density + more) * wall, 7e-7 * density * wall);
}

/// Solved once for all cases of one program.
class Solid : public ::testing::Test {
 protected:
  static const SolidCurve& curve() {
    static const SolidCurve solved = SolidReference({}, {}).run(44.0, 1.0);
    return solved;
  }
  static double force_at(double depth_um) { return curve().steps.at(static_cast<std::size_t>(depth_um)).force_uN; }
};

TEST_F(Solid, ConvergesInBalance) {
  ASSERT_EQ(curve().outcome, CurveOutcome::kComplete);
  ASSERT_EQ(curve().steps.size(), 45u);
  for (const SolidStep& step : curve().steps) {
    EXPECT_NEAR(step.force_uN, step.holder_force_uN, 1e-9);
    EXPECT_LT(std::abs(step.volume_change_ratio), 2e-4);
    EXPECT_LT(step.solid_volume_change_ratio, 1.2e-3);
  }
  for (std::size_t k = 3; k + 1 < curve().steps.size(); ++k) {
    const double slope = 0.5 * (curve().steps[k + 1].energy_uN_um - curve().steps[k - 1].energy_uN_um);
    EXPECT_NEAR(curve().steps[k].force_uN, slope, 0.01 * slope) << k;
  }
}

TEST_F(Solid, KeepsItsFigures) {
  EXPECT_NEAR(force_at(4.0), 0.0679, 2e-5);
  EXPECT_NEAR(force_at(10.0), 0.1160, 3e-5);
  EXPECT_NEAR(force_at(20.0), 0.2030, 5e-5);
  EXPECT_NEAR(force_at(30.0), 0.3795, 3e-5);
  EXPECT_NEAR(force_at(44.0), 0.7400, 8e-5);
}

// GetFEM's solid of revolution zigzags at the tip's edge between 6 and 20 um (its outer nodes fold back), which takes
// up to 6 % off its force; before and after it is met within its mesh spread. GetFEM's three-dimensional solid, which
// doesn't, is met there; from 16 um on that one turns oval.
TEST_F(Solid, MeetsTheSolidsOfAnotherProgram) {
  const auto file = test::shared_folder() / "mechanics" / "reference" / "force_config1_oocyte_solidFE.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const Table table = Table::read(file);
  const Eigen::VectorXd depth = table.column("indentation_um"), force = table.column("force_uN");
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    if (depth[row] < 1.0) continue;
    const double allowed = depth[row] < 4.0 || depth[row] > 20.0 ? 0.025 : 0.065;
    EXPECT_NEAR(force_at(depth[row]), force[row], allowed * force[row]) << depth[row];
  }
  const Table other =
      Table::read(test::shared_folder() / "mechanics" / "reference" / "check_GetFEM3D_config1_oocyte.csv");
  const Eigen::VectorXd other_depth = other.column("indentation_um"), other_force = other.column("force_uN");
  for (Eigen::Index row = 0; row < other.rows(); ++row) {
    if (other_depth[row] < 1.0 || other_depth[row] > 13.0) continue;
    EXPECT_NEAR(force_at(other_depth[row]), other_force[row], 0.015 * other_force[row]) << other_depth[row];
  }
}

// GetFEM's axisymmetric solid, as tests/specimens/solid_specimens.py makes it, of the oocyte's sizes with b = 0.3 and
// with b = 0: ratio of the needle's forces.
TEST_F(Solid, StiffensAsAnotherProgramsDoes) {
  const SolidCurve stiff = SolidReference({}, {}, {.stiffening = 0.3}).run(44.0, 4.0);
  ASSERT_EQ(stiff.outcome, CurveOutcome::kComplete);
  const struct {
    double depth_um, ratio;
  } other[] = {{4.0, 1.0014}, {12.0, 1.0144}, {20.0, 1.0270}, {28.0, 1.0336}, {36.0, 1.0407}, {44.0, 1.0505}};
  for (const auto& [depth_um, ratio] : other) {
    const double own = stiff.steps.at(static_cast<std::size_t>(depth_um / 4.0)).force_uN / force_at(depth_um);
    EXPECT_NEAR(own, ratio, 0.009) << depth_um;
  }
}

TEST_F(Solid, ThinShellTheoryIsStifferAtATenthOfTheRadius) {
  const ShellCurve shell = ShellReference({}, {}).run(44.0, 2.0);
  const double at_10 = shell.steps[5].axial_force_uN / force_at(10.0),
               at_44 = shell.steps[22].axial_force_uN / force_at(44.0);
  std::printf("shell over solid: %.3f at 10 um, %.3f at 44 um\n", at_10, at_44);
  EXPECT_NEAR(at_10, 1.09, 0.0065);
  EXPECT_NEAR(at_44, 1.24, 0.003);
}

TEST(SolidReference, ThinShellsAreShells) {
  // At h/R = 0.02 the two theories meet, at small depth and large.
  ShellSpecimen thin;
  thin.thickness_um = 1.0;
  const double shell = ShellReference(thin, {}).run(1.0, 1.0).steps.back().axial_force_uN;
  const double solid = SolidReference(thin, {}).run(1.0, 1.0).steps.back().force_uN;
  std::printf("thin: shell over solid %.3f\n", shell / solid);
  EXPECT_NEAR(shell, solid, 0.01 * solid);
}

TEST(SolidReference, OutOfRangeIsRefused) {
  EXPECT_THROW(SolidReference({}, contact_for_configuration(2)), UsageError);
  EXPECT_THROW(SolidReference({}, contact_for_configuration(4)), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.across = 0}), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.edge_length_ratio = 0.0}), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.stiffening = -0.1}), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.stiffening = 2.5}), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.aspect_ratio = 0.6}), UsageError);
  EXPECT_THROW(SolidReference({}, {}, {.aspect_ratio = 1.5}), UsageError);
}

}  // namespace
}  // namespace pellucida
