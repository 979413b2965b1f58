#include "pellucida/identification/ForceScale.h"

#include <gtest/gtest.h>

#include <random>

#include "TestCells.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

TEST(ForceScale, TakesConfigurationOneThroughThePoint) {
  CellProfile cell = testing::coarse_cell();
  apply(scale_to_point(cell, 7.5, 30.0, 0.05), cell);
  EXPECT_NEAR(force_curve(cell, 1, 30.0, 5.0).back().push_force_uN, 7.5, 5e-7);
  EXPECT_DOUBLE_EQ(cell.force_scale_relative_sigma, 0.05);
}

TEST(ForceScale, OfACurveHasTheStandardErrorOfItsNoise) {
  const CellProfile cell = testing::coarse_cell();
  const ReferenceCurve model = testing::model_curve(cell, 1, 30.0, 1.0);
  constexpr double kRatio = 6.5, kNoise_uN = 0.1;
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0.0, kNoise_uN);
  double square_sum = 0.0, claimed = 0.0;
  constexpr int kTrials = 20;
  for (int trial = 0; trial < kTrials; ++trial) {
    MeasuredCurve measured{model.depth_um, kRatio * model.force_uN};
    for (double& force : measured.force_uN) force += noise(generator);
    const ForceScale scale = scale_to_curve(cell, measured);
    square_sum += std::pow(scale.ratio / kRatio - 1.0, 2) / kTrials;
    claimed += scale.relative_sigma / kTrials;
    EXPECT_NEAR(scale.residual_rms_uN, kNoise_uN, 0.4 * kNoise_uN);
    EXPECT_EQ(scale.point_count, 31);
  }
  // What is claimed is what is found, to the spread of twenty trials.
  EXPECT_NEAR(std::sqrt(square_sum), claimed, 0.5 * claimed);
}

TEST(ForceScale, RefusesWhatItCantMeet) {
  const CellProfile cell = testing::coarse_cell();
  EXPECT_THROW(scale_to_point(cell, 0.0, 30.0, 0.05), UsageError);
  EXPECT_THROW(scale_to_point(cell, 1.0, 100.0, 0.05), UsageError);
  MeasuredCurve pull{Eigen::Vector3d(1.0, 2.0, 3.0), Eigen::Vector3d(-1.0, -2.0, -3.0)};
  EXPECT_THROW(scale_to_curve(cell, pull), NothingMeasuredError);
  pull.indentation_um[2] = 500.0;
  EXPECT_THROW(scale_to_curve(cell, pull), UsageError);
}

}  // namespace
}  // namespace pellucida
