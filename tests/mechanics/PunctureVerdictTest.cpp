#include "PunctureVerdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>

namespace pellucida {
namespace {

using Sight = PunctureVerdict::Sight;
using Shape = PunctureVerdict::Shape;

Sight sight(double tip_um, double tip_sigma_um, double membrane_um, double membrane_sigma_um) {
  return {.tip_um = tip_um,
          .tip_sigma_um = tip_sigma_um,
          .membrane_um = membrane_um,
          .membrane_sigma_um = membrane_sigma_um};
}

/// The same in a frame that the tracker takes for punctured.
Sight tracked(double tip_um, double membrane_um) {
  Sight now = sight(tip_um, 0.4, membrane_um, 0.3);
  now.is_tracked_punctured = true;
  return now;
}

/// A push of `k` uN/um to `depth_um`, frame by frame.
PunctureVerdict pushed(double depth_um, double stiffness_uN_per_um) {
  PunctureVerdict verdict;
  for (double depth = 0.5; depth <= depth_um; depth += 0.5) {
    EXPECT_FALSE(verdict.judge(sight(depth, 0.2, depth, 0.2)));
    verdict.add(depth, stiffness_uN_per_um * depth);
  }
  return verdict;
}

TEST(PunctureVerdict, ReportsTheFrameInWhichTheMembraneLeavesTheTip) {
  PunctureVerdict verdict = pushed(40.0, 0.1);
  EXPECT_TRUE(verdict.judge(sight(40.4, 0.2, 24.0, 0.8)));
  const auto puncture = verdict.take_puncture(3.5);
  ASSERT_TRUE(puncture);
  EXPECT_DOUBLE_EQ(puncture->time_s, 3.5);
  EXPECT_NEAR(puncture->peak_force_uN, 4.0, 1e-12);
  EXPECT_NEAR(puncture->depth_um, 40.0, 1e-12);
  EXPECT_NEAR(puncture->work_uN_um, 0.5 * 0.1 * 40.0 * 40.0, 1e-9);
  // Reported once; it lasts while the tip is inside, and ends when it's out.
  EXPECT_FALSE(verdict.take_puncture(3.6));
  EXPECT_TRUE(verdict.judge(sight(42.0, 0.2, 5.0, 0.8)));
  EXPECT_FALSE(verdict.judge(sight(-1.0, 0.2, 0.0, 0.2)));
}

TEST(PunctureVerdict, AContourThatLagsInADeepDimpleIsNoPuncture) {
  // Far behind the tip, and back by some micrometres now and then: it has not sprung back.
  PunctureVerdict verdict = pushed(24.0, 0.1);
  for (double tip = 36.0; tip < 52.0; tip += 4.0) {
    for (const double membrane : {24.0, 21.0}) {
      EXPECT_FALSE(verdict.judge(sight(tip, 0.3, membrane, 0.3))) << tip << ' ' << membrane;
      verdict.add(membrane, 0.1 * membrane);
    }
  }
}

TEST(PunctureVerdict, DrawingBackIsNoPuncture) {
  PunctureVerdict verdict = pushed(40.0, 0.1);
  for (double depth = 40.0; depth > 0.0; depth -= 2.0) {
    EXPECT_FALSE(verdict.judge(sight(depth, 0.3, depth, 0.3))) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  // The same way back gives the work back.
  EXPECT_NEAR(verdict.work_uN_um(), 0.5 * 0.1 * 2.0 * 2.0, 1e-9);
}

// The depths of a retraction on a relief picture: the contour stays in the dimple while the needle is drawn out of it.
TEST(PunctureVerdict, AContourLeftInTheDimpleThatComesBackToTheTipIsNoPuncture) {
  PunctureVerdict verdict = pushed(30.0, 0.1);
  for (double tip = 27.0; tip > 12.0; tip -= 3.0) {
    EXPECT_FALSE(verdict.judge(sight(tip, 0.4, 29.5, 0.5))) << tip;
    verdict.add(tip, 0.1 * tip);
  }
  EXPECT_FALSE(verdict.judge(sight(12.0, 0.4, 11.0, 0.5)));
  verdict.add(12.0, 1.2);
  EXPECT_FALSE(verdict.judge(sight(9.0, 0.4, 9.0, 0.5)));
}

// One frame, hardly seen, shows flanks deep within: nothing comes back from there in the next.
TEST(PunctureVerdict, AFrameHardlySeenSetsNoDepthToComeBackFrom) {
  PunctureVerdict verdict = pushed(8.0, 0.1);
  Sight now = sight(8.0, 0.4, 8.0, 0.7);
  now.flank_um = 2.5;
  EXPECT_FALSE(verdict.judge(now));
  verdict.add(8.0, 0.8);
  now.confidence = 0.01;
  now.flank_um = 12.0;
  EXPECT_FALSE(verdict.judge(now));
  now.confidence = 0.55;
  now.flank_um = 2.4;
  for (int k = 0; k < 4; ++k) {
    EXPECT_FALSE(verdict.judge(now)) << k;
    EXPECT_FALSE(verdict.is_doubted()) << k;
    verdict.add(8.0, 0.8);
  }
}

TEST(PunctureVerdict, ALagOfTheMembraneWithinItsNoiseIsNoPuncture) {
  PunctureVerdict verdict = pushed(20.0, 0.1);
  EXPECT_FALSE(verdict.judge(sight(20.5, 0.5, 19.0, 0.8)));
  // Nor is a poor sight of it.
  EXPECT_FALSE(verdict.judge(sight(20.5, 0.5, 14.0, 3.0)));
}

TEST(PunctureVerdict, ATipFoundAgainOnTheMembraneIsAContactAgain) {
  PunctureVerdict verdict = pushed(30.0, 0.1);
  EXPECT_TRUE(verdict.judge(sight(30.5, 0.2, 20.0, 0.2)));
  EXPECT_TRUE(verdict.judge(sight(30.5, 0.2, 30.4, 0.2)));
  EXPECT_TRUE(verdict.judge(sight(30.5, 0.2, 30.4, 0.2)));
  EXPECT_FALSE(verdict.judge(sight(30.5, 0.2, 30.4, 0.2)));
}

TEST(PunctureVerdict, AShapeThatLeavesTheModelsAtOnceIsAPuncture) {
  PunctureVerdict verdict = pushed(40.0, 0.1);
  EXPECT_FALSE(verdict.judge(Shape{0.6, 0.4, 1.0}));
  verdict.add(40.5, 4.05);
  EXPECT_TRUE(verdict.judge(Shape{3.3, 2.0, 1.0}));
  ASSERT_TRUE(verdict.take_puncture(1.0));
  // It lasts, also where the contour is still laid on the tip.
  EXPECT_TRUE(verdict.judge(sight(41.0, 0.2, 41.0, 0.2)));
}

TEST(PunctureVerdict, AShapeThatDriftsAwayInwardsOrWasNotSeenIsNone) {
  PunctureVerdict verdict = pushed(40.0, 0.1);
  // A wrong configuration grows slowly.
  for (double residual = 0.5; residual < 6.0; residual += 0.4)
    EXPECT_FALSE(verdict.judge(Shape{residual, residual, 0.5}));
  // Inwards, within what is usual, unseen.
  verdict = pushed(40.0, 0.1);
  EXPECT_FALSE(verdict.judge(Shape{0.6, 0.4, 1.0}));
  EXPECT_FALSE(verdict.judge(Shape{3.5, -3.0, 1.0}));
  verdict = pushed(40.0, 0.1);
  EXPECT_FALSE(verdict.judge(Shape{0.1, 0.0, 1.0}));
  EXPECT_FALSE(verdict.judge(Shape{1.5, 1.5, 1.0}));
  verdict = pushed(40.0, 0.1);
  EXPECT_FALSE(verdict.judge(Shape{std::nan(""), std::nan(""), 1.0}));
  EXPECT_FALSE(verdict.judge(Shape{5.0, 5.0, 1.0}));
}

// The depths of an injection on a flat picture: the tip is lost in the cell's texture and runs ahead, the membrane
// follows the needle as before.
TEST(PunctureVerdict, ATipThatRunsAheadOfAMembraneThatFollowsIsDoubted) {
  PunctureVerdict verdict = pushed(6.8, 0.12);
  const double tip_um[] = {12.1, 19.8, 25.2, 26.4, 26.1, 25.4, 26.5, 28.5, 33.5};
  const double membrane_um[] = {7.8, 9.5, 10.6, 10.6, 10.6, 10.6, 14.8, 18.4, 20.0};
  for (std::size_t k = 0; k < std::size(tip_um); ++k) {
    EXPECT_FALSE(verdict.judge(tracked(tip_um[k], membrane_um[k]))) << k;
    EXPECT_TRUE(verdict.is_doubted()) << k;
    verdict.add(membrane_um[k], 0.12 * membrane_um[k]);
  }
  // Drawn back, tip and membrane together: still none.
  for (double back = 1.0; back < 18.0; back += 1.0) {
    EXPECT_FALSE(verdict.judge(tracked(33.5 - back, 20.0 - back))) << back;
    verdict.add(20.0 - back, 0.1);
  }
}

TEST(PunctureVerdict, ADoubtedContactThatPuncturesIsReportedInItsFrame) {
  PunctureVerdict verdict = pushed(15.0, 0.1);
  for (double depth = 15.5; depth <= 44.0; depth += 0.5) {
    ASSERT_FALSE(verdict.judge(tracked(depth + 8.0, depth))) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  EXPECT_TRUE(verdict.judge(tracked(51.5, 23.7)));
  EXPECT_FALSE(verdict.is_doubted());
  const auto puncture = verdict.take_puncture(4.8);
  ASSERT_TRUE(puncture);
  EXPECT_NEAR(puncture->peak_force_uN, 4.4, 1e-12);
}

// A recoil too slow for one frame, and one that the frame before was too blurred to show.
TEST(PunctureVerdict, ATrackedPunctureIsConfirmedByTheMembranesWayBack) {
  PunctureVerdict verdict = pushed(30.0, 0.1);
  int frames = 0;
  for (double depth = 29.0; !verdict.judge(tracked(30.5, depth)); depth -= 1.5) {
    verdict.add(depth, 0.1 * depth);
    ASSERT_LT(++frames, 9);
  }
  EXPECT_TRUE(verdict.take_puncture(2.0));

  PunctureVerdict blurred = pushed(30.0, 0.1);
  EXPECT_FALSE(blurred.judge(sight(30.2, 8.0, 2.0, 0.3)));
  blurred.add(2.0, 0.2);
  EXPECT_TRUE(blurred.judge(tracked(30.4, 1.5)));
}

TEST(PunctureVerdict, WithoutAContactBeforeTheTrackersWordCounts) {
  PunctureVerdict verdict;
  EXPECT_TRUE(verdict.judge(tracked(40.0, 3.0)));
  EXPECT_FALSE(verdict.is_doubted());
  EXPECT_FALSE(verdict.take_puncture(1.0));
  // A needle that is not seen refutes nothing, and confirms nothing either.
  EXPECT_TRUE(verdict.judge(Sight{.is_tracked_punctured = true, .has_depths = false}));
  verdict = pushed(20.0, 0.1);
  EXPECT_FALSE(verdict.judge(Sight{.is_tracked_punctured = true, .has_depths = false}));
  EXPECT_TRUE(verdict.is_doubted());
}

/// In a frame seen with `confidence`, the dimple's flanks `flank_um` deep.
Sight seen(double tip_um, double membrane_um, double flank_um, double confidence) {
  Sight now = sight(tip_um, 0.3, membrane_um, 0.3);
  now.flank_um = flank_um;
  now.confidence = confidence;
  now.rest_radius_um = 50.0;
  return now;
}

/// A push to `depth_um` with flanks half as deep.
PunctureVerdict pushed_with_flanks(double depth_um, double confidence) {
  PunctureVerdict verdict;
  for (double depth = 0.5; depth <= depth_um; depth += 0.5) {
    EXPECT_FALSE(verdict.judge(seen(depth, depth, 0.5 * depth, confidence)));
    EXPECT_FALSE(verdict.is_doubted()) << depth;
    verdict.add(depth, 0.1 * depth);
  }
  return verdict;
}

TEST(PunctureVerdict, OnePoorFrameDecidesNothing) {
  for (const double confidence : {0.2, 0.43}) {
    PunctureVerdict verdict = pushed_with_flanks(30.0, 0.75);
    EXPECT_FALSE(verdict.judge(seen(30.5, 14.0, 8.0, confidence))) << confidence;
    EXPECT_TRUE(verdict.is_doubted());
    verdict.add(22.0, 2.2);
    // The next frames see the membrane on the tip: no puncture, and soon no doubt.
    for (int k = 0; k < 3; ++k) {
      EXPECT_FALSE(verdict.judge(seen(31.0, 31.0, 15.5, 0.75)));
      verdict.add(31.0, 3.1);
    }
    EXPECT_FALSE(verdict.is_doubted()) << confidence;
  }
}

TEST(PunctureVerdict, OneFrameSeenWellDecidesAndPoorOnesDecideTogether) {
  PunctureVerdict well = pushed_with_flanks(30.0, 0.75);
  EXPECT_TRUE(well.judge(seen(30.5, 9.0, 3.0, 0.75)));

  PunctureVerdict poor = pushed_with_flanks(30.0, 0.75);
  EXPECT_FALSE(poor.judge(seen(30.5, 18.0, 8.0, 0.45)));
  poor.add(24.0, 2.4);
  bool is_through = false;
  for (const double flank : {4.0, 2.5, 1.5}) is_through = is_through || poor.judge(seen(31.0, 2.0 * flank, flank, 0.5));
  EXPECT_TRUE(is_through);
}

TEST(PunctureVerdict, FlanksThatAreBackTellAPunctureWhereTheContourIsTiedToTheTip) {
  PunctureVerdict verdict = pushed_with_flanks(30.0, 0.75);
  int frames = 0;
  for (const double flank : {9.0, 5.0, 3.0, 2.0}) {
    ++frames;
    if (verdict.judge(seen(30.5, 30.5, flank, 0.75))) break;
    verdict.add(30.5, 3.0);
    if (flank < 9.0) {
      EXPECT_LT(verdict.depth_by_flanks_um(), 12.0);
    }
  }
  EXPECT_LE(frames, 3);
  EXPECT_TRUE(verdict.take_puncture(1.0));
}

// A fine needle in a narrow dimple: the contour cuts across it, lags by half and comes out of the model's shape, while
// the flanks go ever deeper.
TEST(PunctureVerdict, FlanksThatGoOnDeeperAreStillPushedWhateverTheContourDoes) {
  PunctureVerdict verdict;
  const auto seen = [](double tip_um, double membrane_um, double flank_um) {
    Sight now = sight(tip_um, 0.2, membrane_um, 0.2);
    now.flank_um = flank_um;
    return now;
  };
  for (double tip = 1.0; tip <= 10.0; tip += 1.0) {
    EXPECT_FALSE(verdict.judge(seen(tip, tip, 0.25 * tip)));
    EXPECT_FALSE(verdict.judge(Shape{.residual_um = 0.5, .dimple_residual_um = 1.0, .usual_um = 0.3}));
    verdict.add(tip, 0.1 * tip);
  }
  for (double tip = 11.0; tip <= 20.0; tip += 1.0) {
    Sight now = seen(tip, 0.7 * tip, 0.25 * tip);
    now.is_tracked_punctured = true;
    EXPECT_FALSE(verdict.judge(now)) << tip;
    EXPECT_TRUE(verdict.is_pushed()) << tip;
    EXPECT_FALSE(verdict.is_doubted()) << tip;
    EXPECT_FALSE(verdict.judge(
        Shape{.residual_um = tip < 14.0 ? 0.5 : 3.0, .dimple_residual_um = tip < 14.0 ? 1.0 : 5.0, .usual_um = 0.3}))
        << tip;
    verdict.add(tip, 0.1 * tip);
  }
  // When it does give way the flanks go, and with them the membrane.
  Sight now = seen(21.0, 6.0, 1.0);
  now.is_tracked_punctured = true;
  EXPECT_TRUE(verdict.judge(now));
}

TEST(PunctureVerdict, FlanksThatGoBackWithTheTipOrBeyondTheRestAreNone) {
  PunctureVerdict drawn_back = pushed_with_flanks(30.0, 0.75);
  for (double depth = 28.0; depth > 0.0; depth -= 2.0) {
    EXPECT_FALSE(drawn_back.judge(seen(depth, depth, 0.5 * depth, 0.75))) << depth;
    drawn_back.add(depth, 0.1 * depth);
  }
  // The cell has moved and the resting outline has not: its flanks come to lie outside that.
  PunctureVerdict moved = pushed_with_flanks(12.0, 0.75);
  for (const double off : {5.0, 6.0, 7.0, 8.0}) {
    EXPECT_FALSE(moved.judge(seen(12.0 - off, 12.0 - off, 6.0 - 1.6 * off, 0.75))) << off;
    moved.add(12.0 - off, 0.1);
  }
  // A cell found anew: other depths, from another outline.
  PunctureVerdict anew = pushed_with_flanks(30.0, 0.75);
  Sight other = seen(20.0, 9.0, 3.0, 0.75);
  other.rest_radius_um = 44.0;
  EXPECT_FALSE(anew.judge(other));
}

TEST(PunctureVerdict, ARevokedPunctureIsAContactWhateverTheTrackerSays) {
  PunctureVerdict verdict = pushed_with_flanks(30.0, 0.9);
  EXPECT_TRUE(verdict.judge(seen(30.5, 9.0, 3.0, 0.9)));
  ASSERT_TRUE(verdict.take_puncture(1.0));
  Sight together = seen(30.5, 30.4, 15.0, 0.9);
  together.is_tracked_punctured = true;
  EXPECT_TRUE(verdict.judge(together));
  EXPECT_FALSE(verdict.is_revoked());
  EXPECT_TRUE(verdict.judge(together));
  EXPECT_FALSE(verdict.judge(together));
  EXPECT_TRUE(verdict.is_revoked());
  verdict.add(30.4, 3.0);
  EXPECT_FALSE(verdict.judge(together));
  EXPECT_FALSE(verdict.is_revoked());
  // The flanks are seen, and as deep as they were.
  EXPECT_TRUE(verdict.is_pushed());
  EXPECT_FALSE(verdict.is_doubted());
  // And the next one is reported again.
  for (int k = 0; k < 3; ++k) verdict.judge(seen(31.0, 31.0, 15.5, 0.9));
  EXPECT_TRUE(verdict.judge(seen(31.5, 6.0, 2.0, 0.9)));
  EXPECT_TRUE(verdict.take_puncture(2.0));
}

// The flanks that a needle drawn back slowly takes with it go sooner than the membrane on its tip.
TEST(PunctureVerdict, FlanksThatGoWithANeedleDrawnBackAreNoRecoil) {
  PunctureVerdict verdict;
  const auto passes = [&](double depth_um, double flank_um) {
    EXPECT_FALSE(verdict.judge(seen(depth_um, depth_um, flank_um, 0.94))) << depth_um;
    verdict.add(depth_um, 0.1 * depth_um);
  };
  for (double depth = 0.5; depth <= 20.0; depth += 0.5) passes(depth, 0.0138 * depth * depth);
  const double depths[] = {18.7, 17.1, 15.5, 13.8, 12.2, 10.5, 8.9}, flanks[] = {4.8, 4.0, 3.1, 2.5, 1.9, 1.4, 1.1};
  for (std::size_t k = 0; k < std::size(flanks); ++k) passes(depths[k], flanks[k]);
}

TEST(PunctureVerdict, AShallowDimpleThatGoesIsAPuncture) {
  PunctureVerdict verdict;
  for (double depth = 0.5; depth <= 4.0; depth += 0.5) {
    EXPECT_FALSE(verdict.judge(seen(depth, depth, 0.2 * depth, 0.9)));
    verdict.add(depth, 0.1 * depth);
  }
  verdict.judge(seen(5.0, 2.0, 0.4, 0.9));
  EXPECT_TRUE(verdict.judge(seen(6.0, 1.2, 0.2, 0.9)));
}

TEST(PunctureVerdict, FlanksAsDeepAsBeforeRevokeAPuncture) {
  PunctureVerdict verdict = pushed_with_flanks(30.0, 0.9);
  EXPECT_TRUE(verdict.judge(seen(30.5, 9.0, 3.0, 0.9)));
  // The contour goes on cutting across the dimple, whose flanks the needle pushes.
  for (int k = 0; k < 2; ++k) EXPECT_TRUE(verdict.judge(seen(31.0, 12.0, 15.5, 0.9)));
  EXPECT_FALSE(verdict.judge(seen(31.5, 12.0, 16.0, 0.9)));
  EXPECT_TRUE(verdict.is_revoked());
  // Nor need they be that deep: what goes deeper from there, flanks and all, is pushed.
  verdict = pushed_with_flanks(30.0, 0.9);
  double deeper = 0.0;
  while (deeper < 8.0 && verdict.judge(seen(30.5, 9.0 + deeper, 3.0 + 0.5 * deeper, 0.9))) deeper += 1.0;
  EXPECT_GT(deeper, 2.0);
  EXPECT_TRUE(verdict.is_revoked());
}

TEST(PunctureVerdict, AContourTiedToTheTipRevokesNothingWhileTheFlanksAreBack) {
  PunctureVerdict verdict = pushed_with_flanks(30.0, 0.9);
  EXPECT_TRUE(verdict.judge(seen(30.5, 9.0, 3.0, 0.9)));
  for (int k = 0; k < 6; ++k) EXPECT_TRUE(verdict.judge(seen(31.0, 31.0, 2.0, 0.9))) << k;
}

TEST(PunctureVerdict, AtFirstSightAMembraneThatIsDeepRefutesTheTracker) {
  PunctureVerdict verdict;
  EXPECT_FALSE(verdict.judge(tracked(33.0, 18.7)));
  EXPECT_TRUE(verdict.is_doubted());
  EXPECT_TRUE(verdict.judge(tracked(33.0, 3.0)));
}

TEST(PunctureVerdict, WithoutAContactThereIsNoPuncture) {
  PunctureVerdict verdict;
  EXPECT_FALSE(verdict.judge(sight(30.0, 0.2, 2.0, 0.2)));
  EXPECT_FALSE(verdict.take_puncture(1.0));
}

}  // namespace
}  // namespace pellucida
