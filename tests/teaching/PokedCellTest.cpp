// The poked cell: its quasi-static limit, the balance of forces on its nodes, and what changes while it runs.
#include "pellucida/teaching/PokedCell.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"
#include "pellucida/teaching/CellSnapshot.h"
#include "pellucida/teaching/QuasiStaticCurve.h"

namespace pellucida {
namespace {

TeachingParameters implicit_parameters() {
  TeachingParameters p;
  p.integrator = "implicit-euler";
  p.time_step_us = 4000.0;
  p.mesh_frequency = 4;
  p.hand_give_um_per_uN = 0.0;
  return p;
}

TeachingParameters explicit_parameters() {
  TeachingParameters p = implicit_parameters();
  p.integrator = "symplectic-euler";
  p.time_step_us = 100.0;
  p.node_mass_kg = 1e-6;
  p.damping_ratio = 0.5;
  return p;
}

void run(PokedCell& cell, double duration_s) {
  const double end_s = cell.time_s() + duration_s;
  while (cell.time_s() < end_s) ASSERT_TRUE(cell.step());
}

int tip_node(const PokedCell& cell) {
  Eigen::Index node = 0;
  cell.model().rest().points_um.row(2).maxCoeff(&node);
  return static_cast<int>(node);
}

double equilibrium_force_uN(const TeachingParameters& p, double depth_um) {
  const CellProfile profile = profile_of(p);
  return Indenter(profile, setup_of(profile, p)).advance_to(depth_um).push_force_uN;
}

TEST(PokedCell, SettlesToTheForceOfTheEquilibrium) {
  for (const bool keeps_volume : {true, false}) {
    TeachingParameters p = implicit_parameters();
    p.keeps_volume = keeps_volume;
    PokedCell cell(p);
    for (const double depth_um : {12.0, 30.0}) {
      cell.set_hand(depth_um, 0.0);
      run(cell, 1.5);
      EXPECT_NEAR(cell.depth_um(), depth_um, 1e-3);
      const double expected_uN = equilibrium_force_uN(p, depth_um);
      EXPECT_GT(expected_uN, 0.1);
      EXPECT_NEAR(cell.push_force_uN() / expected_uN, 1.0, 2e-3) << depth_um << " um, volume kept: " << keeps_volume;
    }
  }
}

TEST(PokedCell, TheCurveBehindTheChartIsThatOfTheEquilibria) {
  const TeachingParameters p = implicit_parameters();
  const auto curve = QuasiStaticStep().process(p);
  ASSERT_TRUE(curve);
  const auto& [of, depth_um, force_uN, fault] = **curve;
  EXPECT_EQ(fault, "");
  EXPECT_TRUE(have_same_curve(of, p));
  ASSERT_EQ(depth_um.size(), force_uN.size());
  ASSERT_GT(depth_um.size(), 20u);
  EXPECT_NEAR(depth_um[15], 30.0, 1e-9);
  EXPECT_NEAR(force_uN[15] / equilibrium_force_uN(p, 30.0), 1.0, 1e-5);
  EXPECT_EQ(force_uN[0], 0.0);
}

TEST(PokedCell, ShownForcesAddUpToTheResidual) {
  for (const auto& p : {implicit_parameters(), explicit_parameters()}) {
    PokedCell cell(p);
    cell.set_hand(20.0, 3.0);
    run(cell, 0.18);
    Eigen::Matrix3Xd total = Eigen::Matrix3Xd::Zero(3, cell.state().x_um.cols());
    cell.dynamics().energy.add(cell.state().x_um, &total, nullptr);
    total = -total;
    cell.model().springs().add_damping(cell.state().x_um, cell.state().v_um_per_s, cell.dynamics().damping_uN_s_per_um,
                                       total);
    total -= p.node_mass_kg * cell.acceleration_um_per_s2();
    double largest_uN = 0.0;
    for (int node = 0; node < total.cols(); ++node) {
      const NodeForces forces = cell.forces_on(node);
      for (const auto& force_uN : forces.force_uN) largest_uN = std::max(largest_uN, force_uN.norm());
      EXPECT_LT((forces.residual_uN() - total.col(node)).norm(), 1e-9) << node;
    }
    EXPECT_GT(largest_uN, 0.3);
  }
}

TEST(PokedCell, EachTermOfANodeHasItsOwnCause) {
  TeachingParameters p = implicit_parameters();
  PokedCell cell(p);
  cell.set_hand(20.0, 0.0);
  run(cell, 0.5);
  const Eigen::Matrix3Xd rest = cell.model().rest().points_um;
  int side = 0;
  for (int node = 0; node < rest.cols(); ++node) {
    if (rest(0, node) > rest(0, side)) side = node;
  }
  const NodeForces at_side = cell.forces_on(side);
  // The needle acts on its patch and nowhere else, in all with the force of the chart; the liquid pushes outwards.
  Eigen::Vector3d needle_uN = Eigen::Vector3d::Zero(), inside_uN = needle_uN;
  for (int node = 0; node < rest.cols(); ++node) {
    const NodeForces forces = cell.forces_on(node);
    needle_uN += forces.of(ForceTerm::kNeedle);
    for (const ForceTerm term : {ForceTerm::kMeridianSprings, ForceTerm::kParallelSprings, ForceTerm::kDiagonalSprings,
                                 ForceTerm::kHinges, ForceTerm::kPressure}) {
      inside_uN += forces.of(term);
    }
  }
  EXPECT_GT(cell.push_force_uN(), 1.0);
  EXPECT_NEAR(needle_uN.z(), -cell.push_force_uN(), 1e-9);
  EXPECT_LT(inside_uN.norm(), 1e-9) << "what acts between nodes adds up to nothing";
  EXPECT_EQ(at_side.of(ForceTerm::kNeedle).norm(), 0.0);
  EXPECT_GT(at_side.of(ForceTerm::kPressure).x(), 0.01);
  EXPECT_GT(at_side.of(ForceTerm::kParallelSprings).norm(), 0.0);
  EXPECT_GT(at_side.of(ForceTerm::kInertia).norm(), 0.0);
  p.keeps_volume = false;
  cell.set_parameters(p);
  run(cell, 0.01);
  EXPECT_EQ(cell.forces_on(side).of(ForceTerm::kPressure).norm(), 0.0);
  EXPECT_THROW(cell.forces_on(static_cast<int>(rest.cols())), UsageError);
}

TEST(PokedCell, ALittleStepLeavesALittleResidual) {
  double residual_uN[2];
  for (int k = 0; k < 2; ++k) {
    TeachingParameters p = explicit_parameters();
    p.time_step_us = k == 0 ? 40.0 : 4.0;
    PokedCell cell(p);
    cell.set_hand(10.0, 0.0);
    run(cell, 0.1);
    residual_uN[k] = cell.forces_on(tip_node(cell)).residual_uN().norm();
  }
  EXPECT_GT(residual_uN[0], 4.0 * residual_uN[1]);
}

TEST(PokedCell, TheTipStaysBehindTheHandByTheForce) {
  TeachingParameters p = implicit_parameters();
  p.hand_give_um_per_uN = 2.0;
  PokedCell cell(p);
  cell.set_hand(30.0, 0.0);
  run(cell, 2.0);
  EXPECT_GT(cell.push_force_uN(), 0.5);
  EXPECT_NEAR(30.0 - cell.depth_um(), 2.0 * cell.push_force_uN(), 0.02);
}

TEST(PokedCell, OutsideTheCellThereIsNoForce) {
  PokedCell cell(implicit_parameters());
  cell.set_hand(15.0, 0.0);
  run(cell, 0.5);
  EXPECT_GT(cell.push_force_uN(), 0.1);
  cell.set_hand(-20.0, 5.0);
  EXPECT_EQ(cell.hand_across_um(), 0.0);
  run(cell, 1.0);
  EXPECT_NEAR(cell.depth_um(), -20.0, 0.01);
  EXPECT_LT(std::abs(cell.push_force_uN()), 1e-3);
}

TEST(PokedCell, AStifferCellPushesBackInProportion) {
  TeachingParameters p = implicit_parameters();
  PokedCell cell(p);
  cell.set_hand(20.0, 0.0);
  run(cell, 1.0);
  const double soft_uN = cell.push_force_uN();
  p.young_modulus_kPa = 2.0 * cell.young_modulus_kPa();
  cell.set_parameters(p);
  EXPECT_NEAR(cell.depth_um(), 20.0, 1e-3) << "the motion goes on where it was";
  run(cell, 1.0);
  EXPECT_NEAR(cell.push_force_uN() / soft_uN, 2.0, 0.01);
}

TEST(PokedCell, AnotherMeshBeginsAtRest) {
  TeachingParameters p = implicit_parameters();
  PokedCell cell(p);
  cell.set_hand(20.0, 0.0);
  run(cell, 0.5);
  p.mesh_frequency = 6;
  cell.set_parameters(p);
  EXPECT_EQ(cell.time_s(), 0.0);
  EXPECT_EQ(cell.state().x_um.cols(), 362);
  EXPECT_LE(cell.depth_um(), 0.0);
  run(cell, 0.5);
  EXPECT_GT(cell.depth_um(), 15.0);
}

TEST(PokedCell, ParametersOutOfRangeAreRefusedAndChangeNothing) {
  TeachingParameters p = implicit_parameters();
  PokedCell cell(p);
  p.time_step_us = 0.0;
  EXPECT_THROW(cell.set_parameters(p), UsageError);
  p = implicit_parameters();
  p.integrator = "leapfrog";
  try {
    cell.set_parameters(p);
    FAIL() << "an unknown integrator was taken";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("symplectic-euler, implicit-euler"), std::string::npos) << error.what();
  }
  EXPECT_EQ(cell.parameters().integrator, "implicit-euler");
  EXPECT_EQ(cell.parameters().time_step_us, 4000.0);
}

TEST(CellSnapshot, HoldsWhatTheCellIs) {
  PokedCell cell(implicit_parameters());
  cell.set_hand(20.0, 0.0);
  run(cell, 1.0);
  const CellSnapshot s = snapshot_of(cell, 7);
  EXPECT_EQ(s.x_um, cell.state().x_um);
  EXPECT_EQ(s.spring_pull_uN.size(), static_cast<Eigen::Index>(s.mesh->pairs.size()));
  // The membrane is stretched somewhere and compressed nowhere more than it is stretched.
  EXPECT_GT(s.spring_pull_uN.maxCoeff(), 0.0);
  EXPECT_EQ(s.force_uN, cell.push_force_uN());
  EXPECT_EQ(s.node_forces.value().node, 7);
  EXPECT_NEAR((s.tip_um - 20.0 * s.mesh->push).norm(), 0.0, 1e-2);
  EXPECT_LT(std::abs(s.volume_change_ratio), 1e-3);
  EXPECT_FALSE(snapshot_of(cell, std::nullopt).node_forces);
}

}  // namespace
}  // namespace pellucida
