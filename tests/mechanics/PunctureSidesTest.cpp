// What the sides of a cell, which bulge while it is pushed, say of a puncture.
#include <gtest/gtest.h>

#include <cmath>

#include "PunctureOdds.h"
#include "PunctureVerdict.h"
#include "PushedShape.h"

namespace pellucida {
namespace {

using Sight = PunctureVerdict::Sight;
using Shape = PunctureVerdict::Shape;

constexpr double kDeepest_um = 30.0, kFlank_ratio = 0.4, kBulge_um = 3.0;

/// The sides' bulge of a push to `depth_um`.
double bulge_um(double depth_um) {
  return kBulge_um * std::pow(depth_um / kDeepest_um, 2);
}

Sight sides_seen(double tip_um, double membrane_um, double flank_um, double side_um) {
  return {.tip_um = tip_um,
          .tip_sigma_um = 0.5,
          .membrane_um = membrane_um,
          .membrane_sigma_um = 0.4,
          .confidence = 0.6,
          .flank_um = flank_um,
          .side_um = side_um,
          .rest_radius_um = 50.0};
}

PunctureVerdict pushed() {
  PunctureVerdict verdict;
  for (double depth = 1.0; depth <= kDeepest_um; depth += 1.0) {
    EXPECT_FALSE(verdict.judge(sides_seen(depth, depth, kFlank_ratio * depth, bulge_um(depth))));
    EXPECT_FALSE(verdict.is_doubted()) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  return verdict;
}

// The contour has lost a deep, narrow dimple, flanks and all, frame after frame, and leaves the model's shape.
TEST(PunctureSides, ACellThatStillBulgesIsPushedWhereverItsContourIsUnderTheTip) {
  PunctureVerdict verdict = pushed();
  EXPECT_FALSE(verdict.judge(Shape{.residual_um = 0.5, .dimple_residual_um = 1.0, .usual_um = 0.3}));
  for (int k = 0; k < 8; ++k) {
    Sight lost = sides_seen(30.0, 9.0, 4.0, 2.9);
    lost.is_tracked_punctured = true;
    EXPECT_FALSE(verdict.judge(lost)) << k;
    EXPECT_TRUE(verdict.is_pushed()) << k;
    EXPECT_FALSE(verdict.judge(Shape{.residual_um = 4.0, .dimple_residual_um = 8.0, .usual_um = 0.3})) << k;
    verdict.add(30.0, 3.0);
  }
  // Without a look at the sides the same frames are a puncture.
  PunctureVerdict blind = pushed();
  bool is_through = false;
  for (int k = 0; k < 8; ++k) is_through = is_through || blind.judge(sides_seen(30.0, 9.0, 4.0, NAN));
  EXPECT_TRUE(is_through);
}

// The contour stays on the tip, which a tracker ties it to, and the flanks beside it are slow to follow.
TEST(PunctureSides, SidesThatGoBackTellAPuncture) {
  PunctureVerdict verdict = pushed();
  int frames = 0;
  for (const double share : {0.55, 0.35, 0.25, 0.2}) {
    ++frames;
    if (verdict.judge(sides_seen(30.5, 30.0, 0.7 * kFlank_ratio * kDeepest_um, share * kBulge_um))) break;
    verdict.add(30.0, 3.0);
  }
  EXPECT_LE(frames, 3);
  EXPECT_TRUE(verdict.take_puncture(1.0));
}

TEST(PunctureSides, SidesThatGoWithANeedleDrawnBackAreNoRecoil) {
  PunctureVerdict verdict = pushed();
  for (double depth = 28.0; depth > 0.0; depth -= 2.0) {
    EXPECT_FALSE(verdict.judge(sides_seen(depth, depth, kFlank_ratio * depth, bulge_um(depth)))) << depth;
    EXPECT_FALSE(verdict.is_doubted()) << depth;
    verdict.add(depth, 0.1 * depth);
  }
}

TEST(PushedShape, SaysNothingBelowItsNoiseAndKnowsWhatTheNeedlesWayLeaves) {
  PushedShape sides({.least_um = 0.5, .fade_ratio = 0.9, .most_onward_ratio = 1.0});
  EXPECT_TRUE(std::isnan(sides.back(0.4, 10.0, 0.3).back));
  sides.follow(0.4, 10.0);
  EXPECT_TRUE(std::isnan(sides.back(0.1, 10.0, 0.3).back));
  sides.follow(4.0, 20.0);
  EXPECT_NEAR(sides.back(1.0, 20.0, 0.0).back, 0.75, 1e-12);
  EXPECT_NEAR(sides.expected_um(10.0, 0.0), 1.0, 1e-12);
  EXPECT_NEAR(sides.back(1.0, 10.0, 0.0).back, 0.0, 1e-12);
  // Frames that differ by 2 um tell nothing of 4.
  for (int k = 0; k < 40; ++k) sides.learn_noise(k % 2 == 0 ? 1.0 : 3.0);
  EXPECT_TRUE(std::isnan(sides.back(1.0, 20.0, 0.0).back));
}

// A frame seen with full confidence ends what was misread before it: none of the three may fall below nothing.
TEST(PunctureOdds, AreProbabilitiesAfterAnyFrames) {
  PunctureOdds odds;
  for (int k = 0; k < 60; ++k) {
    const bool is_odd = k % 3 == 0;
    odds.weigh({.back_ratio = is_odd ? 0.6 : 0.02,
                .back_sigma_ratio = 0.08,
                .tip_share = is_odd ? 0.2 : 2.5,
                .tip_share_sigma = 0.07,
                .confidence = is_odd ? 0.2 : 1.0,
                .is_apart = is_odd});
    EXPECT_GE(odds.probability(), 0.0) << k;
    EXPECT_LE(odds.probability(), 1.0) << k;
    EXPECT_GE(odds.doubt(), 0.0) << k;
    EXPECT_LE(odds.doubt(), 1.0) << k;
  }
}

}  // namespace
}  // namespace pellucida
