// A needle that lies over one body on its way to another seems to end at the first.
#include "CrossedCell.h"

#include <gtest/gtest.h>

#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

constexpr double kCrossed_px = 25.0, kBehindTip_px = 70.0, kCell_px = 30.0, kCellAhead_px = 45.0;

test::NeedleDrawing needle_over_a_body() {
  test::NeedleDrawing d;
  d.tip = {180.3, 171.6};
  d.slope = 0.02;
  d.disc_behind_px = kBehindTip_px;
  d.disc_radius_px = kCrossed_px;
  return d;
}

Eigen::Vector2d crossed_center(const test::NeedleDrawing& d) {
  return d.tip - kBehindTip_px * d.direction();
}

// The needle as far as it shows before the body, and the cell that it goes to.
SceneReading scene_of(const test::NeedleDrawing& d) {
  SceneReading scene;
  SceneTool needle;
  needle.direction = d.direction();
  needle.tip = d.tip - (kBehindTip_px + kCrossed_px) * d.direction();
  needle.half_width_px = 4.0;
  needle.tip_share = 0.8;
  scene.needles.push_back(needle);
  SceneCell cell;
  cell.center = d.tip + kCellAhead_px * d.direction();
  cell.radius_px = kCell_px;
  cell.share = 1.0;
  scene.cells.push_back(cell);
  return scene;
}

void look(SceneReading& scene, const test::NeedleDrawing& d) {
  const test::NeedlePicture picture = draw(d);
  TipNetwork tips;
  look_past(scene, {crossed_center(d), kCrossed_px, 1.0, 0.0}, FrameSampler(picture.view()), tips);
}

TEST(CrossedCell, ANeedleEndsBehindWhatItCrosses) {
  const test::NeedleDrawing d = needle_over_a_body();
  SceneReading scene = scene_of(d);
  ASSERT_TRUE(is_worked_on(scene, crossed_center(d), kCrossed_px));
  look(scene, d);
  EXPECT_LT((scene.needles[0].tip - d.tip).norm(), 2.0);
  EXPECT_FALSE(is_worked_on(scene, crossed_center(d), kCrossed_px)) << "it is a bystander";
  EXPECT_TRUE(is_worked_on(scene, scene.cells[0].center, kCell_px));
}

TEST(CrossedCell, OneThatEndsAtABodyStaysThere) {
  test::NeedleDrawing d = needle_over_a_body();
  SceneReading scene = scene_of(d);
  const Eigen::Vector2d end = scene.needles[0].tip, center = crossed_center(d);
  d.tip = end;
  d.disc_behind_px = -1.0;
  const test::NeedlePicture picture = draw(d);
  TipNetwork tips;
  look_past(scene, {center, kCrossed_px, 1.0, 0.0}, FrameSampler(picture.view()), tips);
  EXPECT_EQ(scene.needles[0].tip, end);
}

TEST(CrossedCell, WithoutACellBehindItNothingIsLookedFor) {
  const test::NeedleDrawing d = needle_over_a_body();
  SceneReading scene = scene_of(d);
  const Eigen::Vector2d end = scene.needles[0].tip;
  scene.cells.clear();
  look(scene, d);
  EXPECT_EQ(scene.needles[0].tip, end);
}

}  // namespace
}  // namespace pellucida
