// Flanks and sides that are seen to a few hundredths of a micrometre: depths, flanks and sides as the tracker gave them
// in films of specimens.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "PunctureVerdict.h"
#include "PushedShape.h"

namespace pellucida {
namespace {

using Sight = PunctureVerdict::Sight;

Sight seen(double tip_um, double membrane_um, double flank_um, double side_um) {
  return {.tip_um = tip_um,
          .tip_sigma_um = 0.12,
          .membrane_um = membrane_um,
          .membrane_sigma_um = 0.12,
          .confidence = 0.97,
          .flank_um = flank_um,
          .side_um = side_um,
          .rest_radius_um = 63.0};
}

/// Untouched, then pushed to `depth_um` in steps of `step_um`, flanks and sides in proportion to the depth.
PunctureVerdict pushed(double depth_um, double step_um, double flank_ratio, double side_ratio) {
  PunctureVerdict verdict;
  for (int k = 0; k < 20; ++k) verdict.watch(seen(-1.0, 0.0, k % 2 == 0 ? 0.01 : 0.03, 0.025));
  for (double depth = step_um; depth <= depth_um; depth += step_um) {
    EXPECT_FALSE(verdict.judge(seen(depth, depth, flank_ratio * depth, side_ratio * depth))) << depth;
    EXPECT_FALSE(verdict.is_doubted()) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  return verdict;
}

// Film 81255: a fine needle goes through a thin zona; the contour stays on its tip, which goes on.
TEST(PunctureQuietShape, AShallowPunctureUnderAContourThatStaysOnTheTipIsDetected) {
  PunctureVerdict verdict = pushed(4.9, 0.35, 0.25, 0.032);
  const double tip_um[] = {5.18, 5.51, 5.84, 6.20, 6.54}, flank_um[] = {1.235, 0.999, 0.873, 0.808, 0.764},
               side_um[] = {0.157, 0.127, 0.108, 0.097, 0.094};
  std::size_t frames = 0;
  while (frames < std::size(tip_um) &&
         !verdict.judge(seen(tip_um[frames], tip_um[frames] - 0.2, flank_um[frames], side_um[frames]))) {
    verdict.add(tip_um[frames], 0.5);
    ++frames;
  }
  EXPECT_LT(frames, std::size(tip_um));
  EXPECT_TRUE(verdict.take_puncture(1.0));
}

// Film 81259: the contour cuts across the dimple of a fine needle, seen well, frame after frame; the flanks go on.
TEST(PunctureQuietShape, AContourThatCutsAcrossForLongIsNone) {
  PunctureVerdict verdict = pushed(11.4, 0.9, 0.147, 0.02);
  const double tip_um[] = {12.1, 12.8, 13.2, 13.2, 13.0, 12.9, 12.9, 12.9, 12.9},
               flank_um[] = {1.87, 1.99, 2.04, 2.04, 2.03, 2.02, 2.02, 2.02, 2.02};
  for (std::size_t k = 0; k < std::size(tip_um); ++k) {
    Sight now = seen(tip_um[k], 5.3, flank_um[k], NAN);
    now.is_tracked_punctured = true;
    EXPECT_FALSE(verdict.judge(now)) << k;
    verdict.add(11.4, 1.1);
  }
}

// Film 80007: pushed to 0.8 of its radius a cell bulges less and less at its sides.
TEST(PunctureQuietShape, SidesThatTurnBackWhileTheFlanksGoDeeperAreNoRecoil) {
  PunctureVerdict verdict = pushed(30.0, 1.5, 0.7, 0.044);
  const double tip_um[] = {31.7, 33.1, 34.6, 36.1, 37.6, 39.0, 40.5, 41.9, 43.4, 44.8, 46.1},
               flank_um[] = {23.0, 24.9, 26.4, 29.1, 31.3, 33.4, 35.7, 37.4, 39.3, 41.9, 44.6},
               side_um[] = {1.30, 1.27, 1.22, 1.14, 1.03, 0.89, 0.75, 0.62, 0.48, 0.35, 0.25};
  for (std::size_t k = 0; k < std::size(tip_um); ++k) {
    EXPECT_FALSE(verdict.judge(seen(tip_um[k], tip_um[k], flank_um[k], side_um[k]))) << k;
    EXPECT_FALSE(verdict.is_doubted()) << k;
    verdict.add(tip_um[k], 0.1 * tip_um[k]);
  }
}

// Film 82037: at rest 0.84 of the radius deep, with flanks slightly back, the bulge is half of what it was.
TEST(PunctureQuietShape, SidesThatTurnedBackInAHeldPushAreNoRecoil) {
  PunctureVerdict verdict = pushed(37.0, 1.6, 0.8, 0.028);
  const double tip_um[] = {38.9, 40.5, 42.2, 43.6, 44.1, 44.3, 44.2},
               flank_um[] = {32.1, 34.1, 36.3, 35.2, 35.7, 35.6, 35.6},
               side_um[] = {0.93, 0.75, 0.54, 0.37, 0.28, 0.27, 0.26};
  for (std::size_t k = 0; k < 16; ++k) {
    const std::size_t at = std::min(k, std::size(tip_um) - 1);
    EXPECT_FALSE(verdict.judge(seen(tip_um[at], tip_um[at], flank_um[at], side_um[at]))) << k;
    EXPECT_FALSE(verdict.is_doubted()) << k;
    verdict.add(tip_um[at], 0.1 * tip_um[at]);
  }
}

TEST(PunctureQuietShape, TheNoiseOfOneContactIsKnownInTheNext) {
  PunctureVerdict verdict = pushed(4.9, 0.35, 0.25, 0.032);
  verdict.release();
  // No frame between: flanks of 0.4 um still tell.
  for (double depth = 0.4; depth <= 2.0; depth += 0.4) {
    EXPECT_FALSE(verdict.judge(seen(depth, depth, 0.25 * depth, 0.032 * depth)));
    verdict.add(depth, 0.1 * depth);
  }
  bool is_through = false;
  for (const double flank : {0.3, 0.2, 0.15, 0.12}) {
    is_through = is_through || verdict.judge(seen(2.2, 2.1, flank, 0.13 * flank));
    if (!is_through) verdict.add(2.1, 0.2);
  }
  EXPECT_TRUE(is_through);
}

TEST(PushedShape, GrowsWithATipThatGoesOnAndFadesFasterAsItIsDrawnBack) {
  PushedShape flanks({.least_um = 0.1, .fade_ratio = 0.98, .most_onward_ratio = 1.2});
  flanks.follow(2.0, 10.0);
  EXPECT_NEAR(flanks.expected_um(11.0, 0.0), 2.2, 1e-12);
  EXPECT_NEAR(flanks.expected_um(20.0, 0.0), 2.4, 1e-12);
  // Only what is sure of its way counts.
  EXPECT_NEAR(flanks.expected_um(10.5, 0.4), 2.0, 1e-12);
  flanks.fade(10.5);
  EXPECT_NEAR(flanks.most_um(), 1.96, 1e-12);
  flanks.fade(9.0);
  EXPECT_NEAR(flanks.most_um(), 1.764, 1e-12);
}

// A value that rises steadily shows no noise by that.
TEST(PushedShape, TakesASteadyPaceForNoNoise) {
  PushedShape flanks({.least_um = 0.01, .fade_ratio = 0.98, .most_onward_ratio = 1.2});
  const double before_um = flanks.noise_um();
  for (int k = 0; k < 40; ++k) flanks.learn_noise(0.2 * k);
  EXPECT_LT(flanks.noise_um(), 0.2 * before_um);
  for (int k = 0; k < 40; ++k) flanks.learn_noise(k % 2 == 0 ? 0.0 : 0.6);
  EXPECT_GT(flanks.noise_um(), 0.2);
}

// Film 54921, unseen: a contour that is 0.3 um off, otherwise from frame to frame, and says so; its flanks seem to come
// back by half while the needle goes on.
TEST(PunctureQuietShape, FlanksNoDeeperThanTheirContourIsKnownSayNothing) {
  const double tip_um[] = {2.06, 2.70, 3.31, 4.31, 5.09, 5.83, 6.57, 7.37, 8.28},
               flank_um[] = {0.27, 0.32, 0.38, 0.36, 0.29, 0.29, 0.16, 0.44, 0.59},
               side_um[] = {0.11, 0.13, 0.12, 0.15, 0.15, 0.19, 0.17, 0.20, 0.25};
  for (const bool is_said : {true, false}) {
    PunctureVerdict verdict;
    for (int k = 0; k < 6; ++k) verdict.watch(seen(-1.0, 0.0, k % 2 == 0 ? 0.06 : 0.1, 0.09));
    bool is_through = false;
    for (std::size_t k = 0; k < std::size(tip_um) && !is_through; ++k) {
      Sight now = seen(tip_um[k], tip_um[k] - 0.1, flank_um[k], side_um[k]);
      now.tip_sigma_um = now.membrane_sigma_um = 0.27;
      now.confidence = 0.65;
      if (is_said) now.shape_sigma_um = 0.1;
      is_through = verdict.judge(now);
      verdict.add(tip_um[k], 0.3 * tip_um[k]);
    }
    EXPECT_EQ(is_through, !is_said);
  }
}

}  // namespace
}  // namespace pellucida
