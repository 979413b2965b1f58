#include "MotionConstants.h"

#include <gtest/gtest.h>

#include "TestCells.h"
#include "pellucida/dynamics/Integrator.h"

namespace pellucida {
namespace {

TEST(MotionConstants, TheNodesWeighWhatTheCellWeighs) {
  const CellProfile cell = testing::coarse_cell();
  const MembraneModel model(cell, setup_for_configuration(cell, 1));
  const double total_kg = motion_constants(cell).node_mass_kg * static_cast<double>(model.rest().points_um.cols());
  EXPECT_NEAR(total_kg, 6.06e-10, 0.01e-10);  // 606 pl of water: a ball of 52.5 um
}

/// Largest speed after `count` steps of eq. (4) from rest with a small kick.
double speed_after(const CellProfile& cell, double dt_s, int count) {
  MembraneModel model(cell, setup_for_configuration(cell, 1));
  const MotionConstants constants = motion_constants(cell);
  Dynamics dynamics{model.energy(), model.springs(), constants.node_mass_kg, 0.0};
  const auto integrator = make_symplectic_euler(dynamics);
  MotionState state{model.rest().points_um, Eigen::Matrix3Xd::Zero(3, model.rest().points_um.cols())};
  state.v_um_per_s.col(5) << 1.0, -2.0, 1.5;
  for (int k = 0; k < count; ++k) {
    if (!integrator->step(state, dt_s)) return 1e300;
  }
  return state.v_um_per_s.cwiseAbs().maxCoeff();
}

TEST(MotionConstants, TheStableStepIsOfTheRightSize) {
  // A bound is safe, and of use only if it isn't far too small.
  const CellProfile cell = testing::coarse_cell();
  const double stable_s = motion_constants(cell).stable_step_s;
  EXPECT_LT(speed_after(cell, 0.9 * stable_s, 1000), 1e2);
  EXPECT_GT(speed_after(cell, 4.0 * stable_s, 1000), 1e6);
}

TEST(MotionConstants, DampingFollowsMassAndStiffness) {
  CellProfile cell = testing::coarse_cell();
  const MotionConstants one = motion_constants(cell);
  cell.effective_young_modulus_kPa *= 4.0;
  const MotionConstants stiff = motion_constants(cell);
  EXPECT_NEAR(stiff.damping_uN_s_per_um, 2.0 * one.damping_uN_s_per_um, 1e-9 * one.damping_uN_s_per_um);
  EXPECT_NEAR(stiff.stable_step_s, 0.5 * one.stable_step_s, 1e-9 * one.stable_step_s);
}

}  // namespace
}  // namespace pellucida
