// The fit, on curves that the model itself made.
#include "pellucida/identification/ConstantsFit.h"

#include <gtest/gtest.h>

#include "CurveSensitivity.h"
#include "TestCells.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

std::vector<ReferenceCurve> four_curves(const CellProfile& cell) {
  std::vector<ReferenceCurve> curves;
  for (int c = 1; c <= 4; ++c) curves.push_back(testing::model_curve(cell, c, 36.0, 3.0));
  return curves;
}

FitOptions options() {
  FitOptions options;
  options.anchor_um = 36.0;
  options.max_iterations = 40;
  return options;
}

TEST(ConstantsFit, FindsTheConstantsThatMadeTheCurves) {
  CellProfile cell = testing::coarse_cell();
  cell.tip = {1.9, -0.2, 0.8};
  cell.body = {3.0, -0.35, 1.4};
  cell.holder = {2.6, -0.1, 0.9};
  const auto curves = four_curves(cell);
  CellProfile fitted = cell;
  set_starting_constants(fitted);
  const FitReport report = fit_constants(fitted, curves, options());
  ASSERT_TRUE(report.complete);
  EXPECT_LT(report.worst_unit, 0.01);  // 0.05 % of the force, 0.03 % of the peak: the pull to the start takes the rest

  // What the curves determine well is recovered: the body's springs and plates, and the tip's plates. The tip's springs
  // and those by the holder trade with them.
  EXPECT_NEAR(fitted.body.k2_ratio, cell.body.k2_ratio, 1e-3 * cell.body.k2_ratio);
  EXPECT_NEAR(fitted.body.hinge_ratio, cell.body.hinge_ratio, 0.014 * cell.body.hinge_ratio);
  EXPECT_NEAR(fitted.tip.hinge_ratio, cell.tip.hinge_ratio, 0.05 * cell.tip.hinge_ratio);
}

TEST(ConstantsFit, KeepsConnectorsFromTurningSoft) {
  CellProfile cell = testing::coarse_cell();
  cell.tip = {1.9, -0.6, 0.8};
  cell.body = {3.0, -0.6, 1.4};
  const auto curves = four_curves(cell);
  CellProfile fitted = cell;
  FitOptions bounded = options();
  bounded.largest_strain = 1.0;
  bounded.max_iterations = 6;
  ASSERT_TRUE(fit_constants(fitted, curves, bounded).complete);
  for (const RegionConstants* r : {&fitted.tip, &fitted.body, &fitted.holder}) {
    EXPECT_GE(r->k1_over_k2, -1.0 / 3.0 - 1e-9);
  }
}

TEST(ConstantsFit, IsTheSameInOneThreadAndInFour) {
  const CellProfile cell = testing::coarse_cell();
  const auto curves = four_curves(cell);
  FitOptions few = options();
  few.max_iterations = 3;
  CellProfile one = cell, four = cell;
  set_starting_constants(one);
  set_starting_constants(four);
  few.threads = 1;
  fit_constants(one, curves, few);
  few.threads = 4;
  fit_constants(four, curves, few);
  EXPECT_EQ(constants_of(one), constants_of(four));
}

TEST(ConstantsFit, CanBeCancelled) {
  CellProfile cell = testing::coarse_cell();
  const auto curves = four_curves(cell);
  set_starting_constants(cell);
  const ModelConstants before = constants_of(cell);
  std::stop_source stop;
  const FitReport report = fit_constants(
      cell, curves, options(),
      [&](int evaluations, double) {
        if (evaluations >= 2) stop.request_stop();
      },
      stop.get_token());
  EXPECT_FALSE(report.complete);
  EXPECT_LE(report.evaluations, 3);
  EXPECT_EQ(constants_of(cell), before);
}

TEST(ConstantsFit, NoCurveIsNoFit) {
  CellProfile cell = testing::coarse_cell();
  EXPECT_THROW(fit_constants(cell, {}, options()), UsageError);
}

}  // namespace
}  // namespace pellucida
