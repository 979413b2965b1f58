#include "pellucida/mechanics/PunctureMonitor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

/// A push of `k` uN/um to `depth_um`, frame by frame.
PunctureMonitor pushed(double depth_um, double stiffness_uN_per_um) {
  PunctureMonitor monitor;
  for (double depth = 0.5; depth <= depth_um; depth += 0.5) {
    EXPECT_FALSE(monitor.is_through({depth, 0.2, depth, 0.2}));
    monitor.add(depth, stiffness_uN_per_um * depth);
  }
  return monitor;
}

TEST(PunctureMonitor, TellsTheFrameInWhichTheMembraneLeavesTheTip) {
  PunctureMonitor monitor = pushed(40.0, 0.1);
  EXPECT_TRUE(monitor.is_through({40.4, 0.2, 30.0, 0.8}));
  const auto puncture = monitor.take_puncture(3.5);
  ASSERT_TRUE(puncture);
  EXPECT_DOUBLE_EQ(puncture->time_s, 3.5);
  EXPECT_NEAR(puncture->peak_force_uN, 4.0, 1e-12);
  EXPECT_NEAR(puncture->depth_um, 40.0, 1e-12);
  EXPECT_NEAR(puncture->work_uN_um, 0.5 * 0.1 * 40.0 * 40.0, 1e-9);
  // Told once; it lasts while the tip is inside, and ends when it's out.
  EXPECT_FALSE(monitor.take_puncture(3.6));
  EXPECT_TRUE(monitor.is_through({42.0, 0.2, 5.0, 0.8}));
  EXPECT_FALSE(monitor.is_through({-1.0, 0.2, 0.0, 0.2}));
}

TEST(PunctureMonitor, DrawingBackIsNoPuncture) {
  PunctureMonitor monitor = pushed(40.0, 0.1);
  for (double depth = 40.0; depth > 0.0; depth -= 2.0) {
    EXPECT_FALSE(monitor.is_through({depth, 0.3, depth, 0.3})) << depth;
    monitor.add(depth, 0.1 * depth);
  }
  // The same way back gives the work back.
  EXPECT_NEAR(monitor.work_uN_um(), 0.5 * 0.1 * 2.0 * 2.0, 1e-9);
}

TEST(PunctureMonitor, ALagOfTheMembraneWithinItsNoiseIsNoPuncture) {
  PunctureMonitor monitor = pushed(20.0, 0.1);
  EXPECT_FALSE(monitor.is_through({20.5, 0.5, 19.0, 0.8}));
  // Nor is a poor sight of it.
  EXPECT_FALSE(monitor.is_through({20.5, 0.5, 14.0, 3.0}));
}

TEST(PunctureMonitor, ATipFoundAgainOnTheMembraneIsAContactAgain) {
  PunctureMonitor monitor = pushed(30.0, 0.1);
  EXPECT_TRUE(monitor.is_through({30.5, 0.2, 20.0, 0.2}));
  EXPECT_TRUE(monitor.is_through({30.5, 0.2, 30.4, 0.2}));
  EXPECT_TRUE(monitor.is_through({30.5, 0.2, 30.4, 0.2}));
  EXPECT_FALSE(monitor.is_through({30.5, 0.2, 30.4, 0.2}));
}

TEST(PunctureMonitor, AShapeThatLeavesTheModelsAtOnceIsAPuncture) {
  PunctureMonitor monitor = pushed(40.0, 0.1);
  EXPECT_FALSE(monitor.has_sprung_back(0.6, 0.4, 1.0));
  monitor.add(40.5, 4.05);
  EXPECT_TRUE(monitor.has_sprung_back(3.3, 2.0, 1.0));
  ASSERT_TRUE(monitor.take_puncture(1.0));
  // It lasts, also where the contour is still laid on the tip.
  EXPECT_TRUE(monitor.is_through({41.0, 0.2, 41.0, 0.2}));
}

TEST(PunctureMonitor, AShapeThatDriftsAwayInwardsOrWasNotSeenIsNone) {
  PunctureMonitor monitor = pushed(40.0, 0.1);
  // A wrong configuration grows slowly.
  for (double residual = 0.5; residual < 6.0; residual += 0.4)
    EXPECT_FALSE(monitor.has_sprung_back(residual, residual, 0.5));
  // Inwards, within what is usual, unseen.
  monitor = pushed(40.0, 0.1);
  EXPECT_FALSE(monitor.has_sprung_back(0.6, 0.4, 1.0));
  EXPECT_FALSE(monitor.has_sprung_back(3.5, -3.0, 1.0));
  monitor = pushed(40.0, 0.1);
  EXPECT_FALSE(monitor.has_sprung_back(0.1, 0.0, 1.0));
  EXPECT_FALSE(monitor.has_sprung_back(1.5, 1.5, 1.0));
  monitor = pushed(40.0, 0.1);
  EXPECT_FALSE(monitor.has_sprung_back(std::nan(""), std::nan(""), 1.0));
  EXPECT_FALSE(monitor.has_sprung_back(5.0, 5.0, 1.0));
}

TEST(PunctureMonitor, WithoutAContactThereIsNoPuncture) {
  PunctureMonitor monitor;
  EXPECT_FALSE(monitor.is_through({30.0, 0.2, 2.0, 0.2}));
  EXPECT_FALSE(monitor.take_puncture(1.0));
}

}  // namespace
}  // namespace pellucida
