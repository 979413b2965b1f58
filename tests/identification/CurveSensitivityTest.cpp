// The curve's exact derivatives by the constants, against finite differences.
#include "CurveSensitivity.h"

#include <gtest/gtest.h>

#include "TestCells.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

class Slopes : public ::testing::TestWithParam<int> {};

TEST_P(Slopes, AreThoseOfFiniteDifferences) {
  const CellProfile cell = testing::coarse_cell();
  const CurveSensitivity model(cell, setup_for_configuration(cell, GetParam()));
  const Eigen::VectorXd depths = Eigen::Vector3d(5.0, 15.0, 30.0);
  const ModelConstants constants = constants_of(cell);
  const CurveWithSlopes curve = model.solve(constants, depths);
  ASSERT_TRUE(curve.complete);
  for (Eigen::Index c = 0; c < constants.size(); ++c) {
    const double step = 1e-3 * std::max(0.1, std::abs(constants[c]));
    ModelConstants more = constants, less = constants;
    more[c] += step;
    less[c] -= step;
    const Eigen::VectorXd difference =
        (model.solve(more, depths).force_uN - model.solve(less, depths).force_uN) / (2.0 * step);
    for (Eigen::Index k = 0; k < depths.size(); ++k) {
      // The solver stops at a residual of 1e-5 of the force scale: differences carry that noise.
      EXPECT_NEAR(curve.slopes_uN(k, c), difference[k], 1.6e-3 * std::abs(difference[k]) + 8e-4 * curve.force_uN[k])
          << "constant " << c << " at " << depths[k] << " um";
    }
  }
}

TEST_P(Slopes, SumUpToTheForceOfAModelThatScales) {
  // All energies but the bonds' and the liquid's are linear in the constants: F is nearly theirs alone, since bonds
  // and liquid are stiff, so the slopes times the constants give nearly the force.
  const CellProfile cell = testing::coarse_cell();
  const CurveSensitivity model(cell, setup_for_configuration(cell, GetParam()));
  const ModelConstants constants = constants_of(cell);
  const CurveWithSlopes curve = model.solve(constants, Eigen::Vector2d(10.0, 30.0));
  const Eigen::VectorXd sum = curve.slopes_uN * constants;
  for (Eigen::Index k = 0; k < sum.size(); ++k) {
    EXPECT_GT(sum[k], 0.7 * curve.force_uN[k]);
    EXPECT_LT(sum[k], 1.01 * curve.force_uN[k]);
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, Slopes, ::testing::Values(1, 3, 4));

TEST(CurveSensitivity, ConstantsGoThereAndBack) {
  CellProfile cell = testing::coarse_cell(), other = cell;
  other.tip = other.body = other.holder = {1.0, 0.0, 1.0};
  set_constants(other, constants_of(cell));
  EXPECT_DOUBLE_EQ(other.holder.k1_over_k2, cell.holder.k1_over_k2);
  EXPECT_DOUBLE_EQ(other.tip.hinge_ratio, cell.tip.hinge_ratio);
}

TEST(CurveSensitivity, DepthsThatFallAreRefused) {
  const CellProfile cell = testing::coarse_cell();
  const CurveSensitivity model(cell, setup_for_configuration(cell, 1));
  EXPECT_THROW(model.solve(constants_of(cell), Eigen::Vector2d(5.0, 3.0)), UsageError);
}

}  // namespace
}  // namespace pellucida
