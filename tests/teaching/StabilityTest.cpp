// The stability limit: what the theory says, and what the cell does on either side of it.
#include "pellucida/teaching/StabilityLimit.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "pellucida/linear_algebra/BlockMatrix.h"
#include "pellucida/teaching/PokedCell.h"

namespace pellucida {
namespace {

TeachingParameters parameters_for(const char* integrator, double damping_ratio) {
  TeachingParameters p;
  p.integrator = integrator;
  p.node_mass_kg = 1e-6;
  p.damping_ratio = damping_ratio;
  p.mesh_frequency = 4;
  p.time_step_us = 10.0;
  return p;
}

/// Whether a poked cell is still sound after `steps` steps of a multiple of its own limit.
std::optional<BlowUp> end_of(TeachingParameters p, double multiple, int steps) {
  p.time_step_us = 1e6 * multiple * PokedCell(p).stability().stable_step_s;
  PokedCell cell(p);
  cell.set_hand(5.0, 0.0);
  for (int k = 0; k < steps && cell.step(); ++k) {
  }
  return cell.blow_up();
}

TEST(Stability, StiffestModeIsTheHessiansLargestEigenvalue) {
  const PokedCell cell(parameters_for("symplectic-euler", 0.0));
  // Gradient and Hessian column by column, all 486 of them.
  const Eigen::Matrix3Xd& rest = cell.model().rest().points_um;
  Eigen::MatrixXd hessian(rest.size(), rest.size());
  for (Eigen::Index k = 0; k < rest.size(); ++k) {
    Eigen::Matrix3Xd x = rest, above = Eigen::Matrix3Xd::Zero(3, rest.cols()), below = above;
    x.data()[k] += 1e-4;
    cell.model().energy().add(x, &above, nullptr);
    x.data()[k] -= 2e-4;
    cell.model().energy().add(x, &below, nullptr);
    hessian.col(k) = Eigen::Map<const Eigen::VectorXd>(above.data(), above.size()) -
                     Eigen::Map<const Eigen::VectorXd>(below.data(), below.size());
  }
  hessian = (hessian + hessian.transpose()).eval() / 4e-4;
  const double largest =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  EXPECT_NEAR(cell.stability().stiffest_mode_uN_per_um / largest, 1.0, 1e-3);
  EXPECT_NEAR(cell.stability().stable_step_s * cell.stability().omega_max_per_s, 2.0, 1e-9);
  EXPECT_NEAR(cell.stability().omega_max_per_s / std::sqrt(largest / 1e-6), 1.0, 1e-3);
}

TEST(Stability, LimitPredictsBlowUpOnEitherSide) {
  for (const auto& [integrator, damping_ratio] : {std::pair{"symplectic-euler", 0.0},
                                                  {"symplectic-euler", 0.3},
                                                  {"symplectic-euler", 1.5},
                                                  {"linear-acceleration", 0.0}}) {
    const TeachingParameters p = parameters_for(integrator, damping_ratio);
    const auto below = end_of(p, 0.97, 1500);
    EXPECT_FALSE(below) << integrator << ", damping ratio " << damping_ratio;
    const auto above = end_of(p, 1.03, 1500);
    ASSERT_TRUE(above) << integrator << ", damping ratio " << damping_ratio;
    EXPECT_TRUE(above->is_beyond_limit());
    EXPECT_TRUE(std::isfinite(above->stable_step_s));
  }
}

TEST(Stability, ImplicitEulerHasNoLimit) {
  const PokedCell cell(parameters_for("implicit-euler", 0.1));
  EXPECT_TRUE(std::isinf(cell.stability().stable_step_s));
  EXPECT_GT(cell.stability().omega_max_per_s, 1000.0);
}

TEST(Stability, DampersMakeTheExplicitLimitSmaller) {
  const auto limit_s = [](const char* integrator, double damping_ratio) {
    TeachingParameters p = parameters_for(integrator, damping_ratio);
    p.mesh_frequency = 6;
    return PokedCell(p).stability().stable_step_s;
  };
  const double none_s = limit_s("symplectic-euler", 0.0);
  EXPECT_LT(limit_s("symplectic-euler", 1.0), 0.9 * none_s);
  const double linear_s = limit_s("linear-acceleration", 1.0);
  EXPECT_NEAR(linear_s / none_s, std::sqrt(3.0), 1e-3);
}

// What lets a slider mark its stable part: h = dt sqrt(E / m) alone decides.
TEST(Stability, LimitGoesWithTheRootOfMassOverModulus) {
  TeachingParameters p = parameters_for("symplectic-euler", 0.5);
  const double before_s = PokedCell(p).stability().stable_step_s;
  p.node_mass_kg *= 9.0;
  p.young_modulus_kPa = 4.0 * PokedCell(p).young_modulus_kPa();
  EXPECT_NEAR(PokedCell(p).stability().stable_step_s / before_s, 1.5, 5e-3);
}

TEST(Stability, ABrokenMotionStaysSoundAndBeginsAgain) {
  TeachingParameters p = parameters_for("symplectic-euler", 0.0);
  p.time_step_us = 2e6 * PokedCell(p).stability().stable_step_s;
  PokedCell cell(p);
  cell.set_hand(5.0, 0.0);
  int steps = 0;
  while (cell.step()) ASSERT_LT(++steps, 5000);
  ASSERT_TRUE(cell.blow_up());
  EXPECT_GT(cell.blow_up()->kinetic_energy_pJ, cell.blow_up()->supplied_energy_pJ);
  EXPECT_TRUE(cell.state().x_um.allFinite());
  const double end_s = cell.time_s();
  EXPECT_FALSE(cell.step());
  EXPECT_EQ(cell.time_s(), end_s);

  // A sound step alone doesn't heal it; a start from rest does.
  p.time_step_us = 10.0;
  cell.set_parameters(p);
  EXPECT_FALSE(cell.step());
  EXPECT_GT(cell.stability().stable_step_s, 1e-6 * p.time_step_us);
  cell.restart();
  EXPECT_FALSE(cell.blow_up());
  for (int k = 0; k < 500; ++k) ASSERT_TRUE(cell.step());
}

}  // namespace
}  // namespace pellucida
