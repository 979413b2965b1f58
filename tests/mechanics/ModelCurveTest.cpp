#include "pellucida/mechanics/ModelCurve.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {
namespace {

Observation free_frame(double outer_um, double inner_um) {
  Observation frame;
  frame.state = CellState::kFree;
  frame.outer.emplace();
  frame.rest_outer_radius_um = outer_um;
  frame.rest_inner_radius_um = inner_um;
  frame.needle.emplace();
  frame.needle->direction = -Eigen::Vector2d::UnitX();
  frame.needle->tip_um = {80.0, 0.0};
  frame.needle->tip_radius_um = 5.0;
  frame.axis = Eigen::Vector2d::UnitX();
  return frame;
}

TEST(ModelCurve, OfTheProfilesCellIsTheForceCommands) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const ModelCurve curve = model_curve(profile, 12.0, 4.0);
  const auto expected = force_curve(profile, 1, 12.0, 4.0);
  ASSERT_EQ(curve.force_uN.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(curve.force_uN[i], expected[i].push_force_uN, 1e-9);
    EXPECT_EQ(curve.indentation_um[i], expected[i].depth_um);
  }
  EXPECT_NEAR(model_curve(profile, 12.0, 4.0, 2.0).force_uN.back(), 2.0 * curve.force_uN.back(), 1e-12);
  EXPECT_THROW(model_curve(profile, 0.0, 1.0), UsageError);
}

TEST(ModelCurve, ASmallerCellOfTheSameZonaIsStiffer) {
  const CellProfile profile = load_profile("mouse-oocyte");
  const auto at = [&](double outer_um) {
    const auto cell = seen_cell(std::vector{free_frame(outer_um, outer_um - profile.thickness_um)}, profile);
    EXPECT_TRUE(cell);
    EXPECT_FALSE(cell->thickness_assumed);
    EXPECT_TRUE(cell->holder_assumed);
    return model_curve(profile, *cell, 20.0, 5.0).force_uN.back();
  };
  const double usual_um = profile.mid_radius_um + 0.5 * profile.thickness_um;
  EXPECT_GT(at(0.85 * usual_um), 1.1 * at(usual_um));
}

TEST(ModelCurve, AFrameWithoutAMembraneSaysNothing) {
  const CellProfile profile = load_profile("mouse-oocyte");
  EXPECT_FALSE(seen_cell({}, profile));
  EXPECT_FALSE(seen_cell(std::vector{Observation{}}, profile));
}

TEST(ModelCurve, EndsWhenItIsTold) {
  const ModelCurve curve = model_curve(load_profile("mouse-oocyte"), 20.0, 1.0, 1.0, [] { return false; });
  EXPECT_EQ(curve.force_uN.size(), 1U);
}

}  // namespace
}  // namespace pellucida
