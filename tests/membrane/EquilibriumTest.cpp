#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/membrane/NormalObservationTerm.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

using testing::coarse_profile;

class Equilibrium : public ::testing::TestWithParam<int> {};

TEST_P(Equilibrium, ForcesAndMomentsBalanceAndTheVolumeIsKept) {
  const CellProfile profile = load_profile("mouse-oocyte");
  Indenter indenter(profile, setup_for_configuration(profile, GetParam()));
  for (const double depth : {3.0, 12.0, 30.0, 44.0}) {
    const IndentationState state = indenter.advance_to(depth);
    ASSERT_EQ(state.report.status, SolveStatus::kConverged) << depth;
    EXPECT_GT(state.push_force_uN, 0.0);
    EXPECT_LT((state.tip_force_uN + state.holder_force_uN).norm(), 1e-9 * state.tip_force_uN.norm());
    const Eigen::Vector3d moment = indenter.model().tip().moment_uN_um(indenter.positions_um()) +
                                   indenter.model().holder().moment_uN_um(indenter.positions_um());
    EXPECT_LT(moment.norm(), 7e-5 * 50.0 * state.tip_force_uN.norm());
    EXPECT_NEAR(state.volume_um3 / indenter.model().volume().rest_volume_um3(), 1.0, 2.5e-4);
    EXPECT_GT(state.pressure_Pa, 0.0);
  }
}

TEST_P(Equilibrium, ThePathDoesNotMatter) {
  const CellProfile profile = coarse_profile();
  Indenter slow(profile, setup_for_configuration(profile, GetParam()));
  for (double depth = 0.5; depth <= 26.0; depth += 0.5) slow.advance_to(depth);
  slow.advance_to(31.0);
  const IndentationState back = slow.advance_to(20.0);
  Indenter quick(profile, setup_for_configuration(profile, GetParam()));
  const IndentationState there = quick.advance_to(20.0);
  EXPECT_NEAR(back.push_force_uN, there.push_force_uN, 5e-6 * there.push_force_uN);

  // And all the way back there is no force left.
  const IndentationState released = slow.advance_to(0.0);
  EXPECT_EQ(released.report.status, SolveStatus::kConverged);
  EXPECT_NEAR(released.push_force_uN, 0.0, 5e-7);
  EXPECT_LT((slow.positions_um() - slow.model().rest().points_um).cwiseAbs().maxCoeff(), 5e-7);
}

TEST_P(Equilibrium, TheTangentStiffnessIsTheCurvesSlope) {
  const CellProfile profile = coarse_profile();
  Indenter indenter(profile, setup_for_configuration(profile, GetParam()));
  SolveOptions tight;
  tight.tolerance_um = 1e-8;
  indenter.set_options(tight);
  for (const double depth : {2.0, 15.0, 35.0}) {
    const double below = indenter.advance_to(depth - 0.01).push_force_uN;
    const IndentationState state = indenter.advance_to(depth);
    const double above = indenter.advance_to(depth + 0.01).push_force_uN;
    EXPECT_NEAR(state.stiffness_uN_per_um, (above - below) / 0.02, 3e-5 * state.stiffness_uN_per_um) << depth;
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, Equilibrium, ::testing::Values(1, 2, 3, 4));

TEST(EquilibriumScale, TheModulusIsTheOnlyForceScale) {
  // Twice the modulus, twice the force, the same shape: a camera alone can never find the scale.
  CellProfile soft = coarse_profile();
  CellProfile stiff = soft;
  stiff.effective_young_modulus_kPa *= 2.0;
  Indenter a(soft, setup_for_configuration(soft, 2)), b(stiff, setup_for_configuration(stiff, 2));
  for (const double depth : {5.0, 25.0}) {
    const double force = a.advance_to(depth).push_force_uN;
    EXPECT_NEAR(b.advance_to(depth).push_force_uN, 2.0 * force, 1e-6 * force);
    EXPECT_LT((a.positions_um() - b.positions_um()).cwiseAbs().maxCoeff(), 1e-5);
  }
}

TEST(EquilibriumSymmetry, AMirrorProblemHasAMirrorSolution) {
  const CellProfile profile = load_profile("mouse-oocyte");
  Indenter indenter(profile, setup_for_configuration(profile, 3));
  const IndentationState state = indenter.advance_to(25.0);
  EXPECT_NEAR(state.tip_force_uN.y(), 0.0, 1e-9 * state.push_force_uN);
  Indenter straight(profile, setup_for_configuration(profile, 1));
  const IndentationState on_axis = straight.advance_to(25.0);
  EXPECT_LT((on_axis.tip_force_uN - on_axis.push_force_uN * -Eigen::Vector3d::UnitZ()).norm(),
            1e-9 * on_axis.push_force_uN);
}

TEST(EquilibriumStatus, ASpentBudgetIsSaidAndTheShapeStaysFinite) {
  const CellProfile profile = coarse_profile();
  Indenter indenter(profile, setup_for_configuration(profile, 1));
  indenter.advance_to(5.0);
  SolveOptions starved;
  starved.max_iterations = 0;
  indenter.set_options(starved);
  const IndentationState state = indenter.advance_to(20.0);
  EXPECT_EQ(state.report.status, SolveStatus::kIterationBudget);
  EXPECT_DOUBLE_EQ(state.depth_um, 5.0);
  EXPECT_TRUE(indenter.positions_um().allFinite());

  // With means to go on, it goes on from there.
  indenter.set_options({});
  EXPECT_EQ(indenter.advance_to(20.0).report.status, SolveStatus::kConverged);
}

TEST(EquilibriumStatus, ASpentTimeIsSaid) {
  const CellProfile profile = coarse_profile();
  Indenter indenter(profile, setup_for_configuration(profile, 1));
  SolveOptions no_time;
  no_time.time_budget_s = 0.0;
  indenter.set_options(no_time);
  const IndentationState state = indenter.advance_to(0.05);
  EXPECT_EQ(state.report.status, SolveStatus::kTimeBudget);
  EXPECT_DOUBLE_EQ(state.depth_um, 0.0);
}

TEST(ToolStiffness, IsHowTheForceFollowsTheTool) {
  const CellProfile profile = coarse_profile();
  MembraneModel model(profile, setup_for_configuration(profile, 2));
  EquilibriumSolver solver(model.energy());
  Eigen::Matrix3Xd x = model.rest().points_um;
  SolveOptions tight;
  tight.tolerance_um = 1e-9;
  model.set_depth(2.0);
  ASSERT_EQ(solver.solve(x, tight).status, SolveStatus::kConverged);
  const Eigen::Matrix3d stiffness = solver.tool_stiffness_uN_per_um(model.tip(), x);
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1.2e-4 * stiffness.norm());

  // Along the push, and towards the holder's side, against differences of equilibria.
  const Eigen::Vector3d at = model.tip().displacement_um();
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(1, 0, 0)}) {
    constexpr double kWay_um = 0.01;
    std::array<Eigen::Vector3d, 2> force;
    for (const int side : {0, 1}) {
      Eigen::Matrix3Xd moved = x;
      model.set_tip_displacement(at + (side == 0 ? -kWay_um : kWay_um) * direction);
      ASSERT_EQ(solver.solve(moved, tight).status, SolveStatus::kConverged);
      force[static_cast<std::size_t>(side)] = model.tip().force_uN(moved);
    }
    const Eigen::Vector3d slope = (force[1] - force[0]) / (2.0 * kWay_um);
    EXPECT_LT((stiffness * direction - slope).norm(), 4e-4 * stiffness.norm());
  }
}

TEST(SolverTerms, AWeakObservationPullsTheShapeButHardlyTheForce) {
  const CellProfile profile = coarse_profile();
  MembraneModel model(profile, setup_for_configuration(profile, 1));
  NormalObservationTerm observation;
  model.energy().add_term(observation);
  EquilibriumSolver solver(model.energy());
  Eigen::Matrix3Xd x = model.rest().points_um;
  model.set_depth(2.0);
  ASSERT_EQ(solver.solve(x, {}).status, SolveStatus::kConverged);
  const Eigen::Vector3d without_uN = model.tip().force_uN(x);

  // Seen half a micrometre outside of where the model is, on the flanks.
  const Eigen::VectorXd areas = node_areas_um2(x, model.rest().triangles);
  std::vector<NormalObservationTerm::Observed> observed;
  for (int node = 0; node < x.cols(); ++node) {
    const Eigen::Vector3d normal = x.col(node).normalized();
    if (std::abs(normal.z()) > 0.5) continue;
    observed.push_back(
        {node, x.col(node) + 0.5 * normal, normal, areas[node], 1e-5 * profile.membrane_stiffness_uN_per_um()});
  }
  observation.set(observed);
  const double before_um = observation.residual_rms_um(x);
  ASSERT_EQ(solver.solve(x, {}).status, SolveStatus::kConverged);
  EXPECT_LT(observation.residual_rms_um(x), before_um);
  EXPECT_NEAR(model.tip().force_uN(x).norm(), without_uN.norm(), 0.02 * without_uN.norm());
  // The observations' pull is part of the balance.
  EXPECT_LT((model.tip().force_uN(x) + model.holder().force_uN(x) + observation.force_uN(x)).norm(),
            1e-9 * without_uN.norm());
}

TEST(ForceCurve, WrongRequestsAreUsageErrors) {
  const CellProfile profile = coarse_profile();
  EXPECT_THROW(force_curve(profile, 0, 10.0, 1.0), UsageError);
  EXPECT_THROW(force_curve(profile, 5, 10.0, 1.0), UsageError);
  EXPECT_THROW(force_curve(profile, 1, -1.0, 1.0), UsageError);
  EXPECT_THROW(force_curve(profile, 1, 10.0, 0.0), UsageError);
  EXPECT_THROW(force_curve(profile, 1, 90.0, 1.0), UsageError);
}

TEST(ForceCurve, EndsAtTheDepthAskedFor) {
  const auto curve = force_curve(coarse_profile(), 1, 2.5, 1.0);
  ASSERT_EQ(curve.size(), 4u);
  EXPECT_DOUBLE_EQ(curve[0].depth_um, 0.0);
  EXPECT_NEAR(curve[0].push_force_uN, 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(curve[2].depth_um, 2.0);
  EXPECT_DOUBLE_EQ(curve[3].depth_um, 2.5);
}

}  // namespace
}  // namespace pellucida
