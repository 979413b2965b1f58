#include "pellucida/operation/DepositTracker.h"

#include <gtest/gtest.h>

namespace pellucida {
namespace {

PipetteState at(double x_um, double expelled_pL) {
  PipetteState state;
  state.known = true;
  state.tip_um = {x_um, 100.0, 3.0};
  state.expelled_pL = expelled_pL;
  return state;
}

const Eigen::Vector2d kCenter_um(200.0, 100.0);

TEST(DepositTracker, ADropletGrowsAtTheTipAndMovesWithTheCell) {
  DepositTracker tracker;
  tracker.see(at(210.0, 5.0), CellState::kPunctured, kCenter_um, 0.0);
  EXPECT_TRUE(tracker.droplets().empty()) << "what was expelled before is elsewhere";
  tracker.see(at(210.0, 5.5), CellState::kPunctured, kCenter_um, 0.1);
  tracker.see(at(210.5, 6.0), CellState::kPunctured, kCenter_um, 0.2);
  ASSERT_EQ(tracker.droplets().size(), 1u);
  EXPECT_NEAR(tracker.droplets()[0].volume_pL, 1.0, 1e-12);
  EXPECT_NEAR(tracker.droplets()[0].radius_um(), 6.2035, 1e-3);  // 1 pL = 1000 um^3
  tracker.see(at(210.0, 6.0), CellState::kFree, Eigen::Vector2d(195.0, 104.0), 0.3);
  ASSERT_EQ(tracker.droplets().size(), 1u);
  EXPECT_NEAR((tracker.droplets()[0].center_um.eigen() - Eigen::Vector3d(205.0, 104.0, 3.0)).norm(), 0.0, 1e-12);
}

TEST(DepositTracker, FarFromADropletAnotherBegins) {
  DepositTracker tracker;
  tracker.see(at(210.0, 0.0), CellState::kPunctured, kCenter_um, 0.0);
  tracker.see(at(210.0, 0.2), CellState::kPunctured, kCenter_um, 0.1);
  tracker.see(at(190.0, 0.4), CellState::kPunctured, kCenter_um, 0.2);
  EXPECT_EQ(tracker.droplets().size(), 2u);
}

TEST(DepositTracker, WhatIsExpelledOutsideIsNoDeposit) {
  DepositTracker tracker;
  tracker.see(at(300.0, 0.0), CellState::kFree, kCenter_um, 0.0);
  tracker.see(at(300.0, 1.0), CellState::kFree, kCenter_um, 0.1);
  tracker.see(at(260.0, 2.0), CellState::kContact, kCenter_um, 0.2);
  tracker.see(at(210.0, 2.0), CellState::kPunctured, kCenter_um, 0.3);
  EXPECT_TRUE(tracker.droplets().empty());
}

TEST(DepositTracker, ACellThatIsGoneTakesItsDepositsAlong) {
  DepositTracker tracker;
  tracker.see(at(210.0, 0.0), CellState::kPunctured, kCenter_um, 0.0);
  tracker.see(at(210.0, 1.0), CellState::kPunctured, kCenter_um, 0.1);
  tracker.see(at(210.0, 1.0), CellState::kNoCell, std::nullopt, 0.9);
  EXPECT_EQ(tracker.droplets().size(), 1u) << "out of view for less than a second";
  tracker.see(at(210.0, 1.0), CellState::kNoCell, std::nullopt, 1.2);
  EXPECT_TRUE(tracker.droplets().empty());
}

}  // namespace
}  // namespace pellucida
