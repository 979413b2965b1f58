// Of two tools that face each other at a cell, the one that moves is the needle.
#include "RivalTool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tracking/NeedleDrawing.h"

namespace pellucida {
namespace {

using Verdict = RivalTool::Verdict;

constexpr double kHalfWidth_px = 3.0;
const contour::Circle kCell{{210.0, 170.0}, 50.0, 1.0, 0.0};

// A tool whose tip lies so far inside the cell's outline, from the right or the left.
test::NeedleDrawing tool_at(bool is_left, double depth_px) {
  test::NeedleDrawing d;
  d.slope = 0.02;
  d.angle_rad = is_left ? std::numbers::pi : 0.0;
  d.tip = kCell.center + Eigen::Vector2d((is_left ? -1.0 : 1.0) * (kCell.radius - depth_px), 2.0);
  return d;
}

// What either of them darkens.
test::NeedlePicture both(const test::NeedleDrawing& a, const test::NeedleDrawing& b) {
  test::NeedlePicture picture = draw(a);
  const test::NeedlePicture other = draw(b);
  std::transform(picture.pixels.begin(), picture.pixels.end(), other.pixels.begin(), picture.pixels.begin(),
                 [](std::uint8_t x, std::uint8_t y) { return std::min(x, y); });
  return picture;
}

NeedleEstimate estimate_of(const test::NeedleDrawing& d) {
  NeedleEstimate estimate;
  estimate.tip = d.tip;
  estimate.direction = d.direction();
  return estimate;
}

// The first verdict that isn't open, and after how many looks; the left tool is watched beside the right one, and both
// go so far a look, as does the cell, to the right.
struct Outcome {
  Verdict verdict = Verdict::kOpen;
  int looks = 0;
};
Outcome watched(double left_px, double right_px, double left_depth_px = 0.0, double cell_px = 0.0) {
  TipNetwork tips;
  RivalTool rival;
  Outcome outcome;
  for (int look = 0; look < 12 && outcome.verdict == Verdict::kOpen; ++look) {
    const test::NeedleDrawing left = tool_at(true, left_depth_px + look * left_px),
                              right = tool_at(false, look * right_px);
    const test::NeedlePicture picture = both(left, right);
    const FrameSampler image(picture.view());
    if (look == 0) {
      NeedleTracker tool;
      EXPECT_TRUE(tool.start_read(tips, image, {left.tip, left.direction()}, kHalfWidth_px));
      rival.begin(std::move(tool), estimate_of(right), kCell);
    } else {
      contour::Circle cell = kCell;
      cell.center.x() += look * cell_px;
      outcome = {rival.watch(tips, image, estimate_of(right), cell), look};
    }
  }
  return outcome;
}

TEST(RivalTool, WhatGoesIntoTheCellIsTheNeedle) {
  const auto [verdict, looks] = watched(1.0, 0.0);
  EXPECT_EQ(verdict, Verdict::kIsNeedle);
  EXPECT_GE(looks, 4);
  EXPECT_LE(looks, 6);
}

TEST(RivalTool, WhatRestsIsTheHolder) {
  EXPECT_EQ(watched(0.0, 1.0).verdict, Verdict::kIsHolder);
  EXPECT_EQ(watched(0.2, 1.0).verdict, Verdict::kIsHolder) << "the cell goes towards its holder";
}

TEST(RivalTool, NothingIsDecidedWhileBothRestOrBothMove) {
  EXPECT_EQ(watched(0.0, 0.0).verdict, Verdict::kOpen);
  EXPECT_EQ(watched(1.0, 1.0).verdict, Verdict::kOpen);
}

// A narrow holding pipette dents the cell as much as the needle does: against the cell both go in.
TEST(RivalTool, WhatRestsInThePictureIsTheHolderOfASoftCell) {
  EXPECT_EQ(watched(1.0, 0.0, 0.0, 0.5).verdict, Verdict::kIsNeedle);
  EXPECT_EQ(watched(0.0, 1.0, 0.0, -0.5).verdict, Verdict::kIsHolder);
}

TEST(RivalTool, AHolderThatCarriesTheCellToTheNeedleIsNone) {
  EXPECT_EQ(watched(1.0, 0.0, 0.0, 1.0).verdict, Verdict::kOpen);
}

// It may be a holding pipette on its way.
TEST(RivalTool, WhatOnlyComesUpToTheCellIsNotItsNeedleYet) {
  EXPECT_EQ(watched(1.0, 0.0, -11.0).verdict, Verdict::kOpen);
}

TEST(RivalTool, AToolOutOfSightIsWatchedNoLonger) {
  TipNetwork tips;
  const test::NeedleDrawing left = tool_at(true, 0.0), right = tool_at(false, 0.0);
  const test::NeedlePicture picture = both(left, right), alone = draw(right);
  NeedleTracker tool;
  ASSERT_TRUE(tool.start_read(tips, FrameSampler(picture.view()), {left.tip, left.direction()}, kHalfWidth_px));
  RivalTool rival;
  rival.begin(std::move(tool), estimate_of(right), kCell);
  for (int look = 0; look < 4; ++look) {
    ASSERT_TRUE(rival.is_watched());
    EXPECT_EQ(rival.watch(tips, FrameSampler(alone.view()), estimate_of(right), kCell), Verdict::kOpen);
  }
  EXPECT_FALSE(rival.is_watched());
}

}  // namespace
}  // namespace pellucida
