#include "ConsoleFixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>

#include "pellucida/core/Error.h"
#include "pellucida/core/NewCellNote.h"

namespace pellucida {
namespace {

TEST_F(OperatorConsoleTest, TheMouseLeadsOnlyWhileItHoldsTheNeedle) {
  choose("Mouse");
  ASSERT_TRUE(console_.is_mouse());
  ASSERT_TRUE(tick_until_state(HandState::kClutched));
  const double start_um = tip_x_um();
  console_.move_px(-50.0, 0.0);
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  EXPECT_EQ(tip_x_um(), start_um);

  console_.grip(true);
  ASSERT_TRUE(tick_until_state(HandState::kWorking));
  // On a starved machine the hand may be taken anew, and what it moved until then does not count: it goes on moving.
  EXPECT_TRUE(tick_until([&] {
    console_.move_px(-10.0, 0.0);
    return tip_x_um() < start_um - 5.0;
  }));

  // The window loses the focus: nothing is held any more.
  console_.release_all();
  ASSERT_TRUE(tick_until_state(HandState::kClutched));
  const double left_um = tip_x_um();
  console_.retract(true);
  EXPECT_TRUE(tick_until([&] { return tip_x_um() > left_um + 5.0; }));
  console_.retract(false);
  EXPECT_TRUE(tick_until_state(HandState::kClutched));
}

TEST_F(OperatorConsoleTest, TheGuideGoesAndTheDepthStopStays) {
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  console_.guide(false);
  EXPECT_FALSE(console_.guided());
  const InjectionPlan plan = *console_.plan();
  console_.depth_stop_um(12.0);
  EXPECT_EQ(console_.depth_stop_um(), 12.0);
  EXPECT_THROW(console_.depth_stop_um(0.0), UsageError);
  console_.scale(0);
  console_.grip(true);
  // Far past the cell: the tip stops 12 um beyond the entry.
  const auto depth_um = [&] {
    return (console_.status().tick.tip_um.eigen() - plan.entry_um.eigen()).dot(plan.axis.eigen());
  };
  ASSERT_TRUE(tick_until([&] {
    console_.move_px(4.0 * plan.axis.x, 4.0 * plan.axis.y);
    return (console_.status().tick.fixtures & kStopBit) != 0 && depth_um() > 8.0;
  }));
  for (int k = 0; k < 20; ++k) {
    console_.move_px(4.0 * plan.axis.x, 4.0 * plan.axis.y);
    console_.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_LT(depth_um(), 14.0);
}

// A cell found to be stiffer than its kind bears the kind's force at a smaller depth: the depth limit follows, also on
// the hand at work, and goes back with the scale.
TEST_F(OperatorConsoleTest, TheDepthLimitFollowsTheCellsOwnScale) {
  choose("Mouse");
  const auto seen = [this] { return run_.scenes()->peek(); };
  ASSERT_TRUE(tick_until([&] { return console_.plan() && seen() && seen()->measurement.expected_puncture_um > 0.0; }));
  const CellLimits before = console_.limits();
  run_.add_scale_measurement({.known_force_uN = 2.0, .at_indentation_um = 10.0, .known_force_sigma_percent = 5.0});
  ASSERT_TRUE(tick_until([&] { return console_.limits().max_depth_um < 0.9 * before.max_depth_um; }));
  const auto scene = seen();
  ASSERT_TRUE(scene && scene->remarks.has_own_scale);
  EXPECT_GT(scene->remarks.scale_ratio, 1.2);
  // A stiffer cell bears the same force at a smaller depth.
  EXPECT_NEAR(console_.limits().max_depth_um, kPunctureMargin * scene->measurement.expected_puncture_um, 0.5);
  EXPECT_NEAR(console_.limits().max_force_uN, before.max_force_uN, 0.02 * before.max_force_uN);
  run_.forget_scale();
  EXPECT_TRUE(tick_until(
      [&] { return std::abs(console_.limits().max_depth_um - before.max_depth_um) < 0.02 * before.max_depth_um; }));
}

TEST_F(OperatorConsoleTest, AnEmergencyStopOutlivesTheHand) {
  choose("Mouse");
  console_.grip(true);
  ASSERT_TRUE(tick_until_state(HandState::kWorking));
  console_.emergency_stop();
  ASSERT_TRUE(tick_until_state(HandState::kStopped));
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return console_.status().tick_count > 20; }));
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kStopped);
  console_.release_emergency_stop();
  EXPECT_TRUE(tick_until_state(HandState::kClutched));
}

// The stop may come from a thread of its own at any moment, while hands and scales are being changed, too.
TEST_F(OperatorConsoleTest, AnEmergencyStopFromAnotherThreadIsNeverLost) {
  for (int round = 0; round < 5; ++round) {
    choose("Mouse");
    ASSERT_TRUE(tick_until_state(HandState::kClutched));
    std::thread other([this, round] {
      std::this_thread::sleep_for(std::chrono::milliseconds(10 * round));
      console_.emergency_stop();
    });
    console_.scale(round % 2 == 0 ? 0 : 2);
    choose("Mouse");
    other.join();
    ASSERT_TRUE(tick_until_state(HandState::kStopped)) << "round " << round;
    console_.release_emergency_stop();
    ASSERT_TRUE(tick_until_state(HandState::kClutched)) << "round " << round;
  }
}

TEST_F(OperatorConsoleTest, ATargetOutsideTheCellIsRefusedWithItsReason) {
  choose("Mouse");
  EXPECT_TRUE(console_.set_target(0.0, 0.0)) << "no plan yet";
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  const PlainVector3 center_um = console_.plan()->cell.center_um;
  const auto refused = console_.set_target(center_um.x + 500.0, center_um.y);
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->find("outside"), std::string::npos) << *refused;
  EXPECT_FALSE(console_.set_target(center_um.x, center_um.y + 8.0));
  EXPECT_NEAR(console_.plan()->target_um.y, center_um.y + 8.0, 1.0);
}

TEST_F(OperatorConsoleTest, NumbersOutOfRangeAreRefused) {
  EXPECT_THROW(console_.choose(-1), UsageError);
  EXPECT_THROW(console_.choose(99), UsageError);
  EXPECT_THROW(console_.scale(3), UsageError);
  EXPECT_FALSE(console_.find_hand("no such hand"));
}

TEST_F(OperatorConsoleTest, ANewCellBringsANeedleThatIsOutOfViewBack) {
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  console_.guide(false);
  console_.scale(0);
  console_.grip(true);
  const double edge_um = run_.source_info().width_px * run_.source_info().pixel_size_um;
  ASSERT_TRUE(tick_until([&] {
    console_.move_px(40.0, 0.0);
    return console_.status().pipette.tip_um.x > edge_um + 20.0;
  }));
  console_.release_all();
  const Eigen::Vector3d start_um = setup_.needle().start_um().eigen();
  const auto away_um = [&] { return (console_.status().pipette.tip_um.eigen() - start_um).norm(); };
  console_.new_cell();
  ASSERT_TRUE(tick_until([&] { return console_.doing() == "Bringing the needle back into view"; }));
  // A stop holds it on its way.
  const double begun_um = away_um();
  ASSERT_TRUE(tick_until([&] { return away_um() < begun_um - 5.0; }));
  console_.emergency_stop();
  ASSERT_TRUE(tick_until_state(HandState::kStopped));
  for (int k = 0; k < 10; ++k) {
    console_.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kStopped);
  EXPECT_GT(away_um(), 10.0);
  console_.release_emergency_stop();
  ASSERT_TRUE(tick_until([&] { return away_um() < 5.0 && console_.is_mouse(); }));
  EXPECT_TRUE(tick_until([&] { return console_.plan().has_value(); })) << "the needle is seen again";
}

TEST_F(OperatorConsoleTest, WithoutHapticsTheHandFeelsNothingOfTheCell) {
  choose("Demonstration");
  console_.guide(false);
  console_.haptics(false);
  double most_N = 0.0;
  ASSERT_TRUE(tick_until([&] {
    const HapticRecord tick = console_.status().tick;
    const bool is_felt = tick.contact_state == ContactState::kContact && tick.contact_force_uN.eigen().norm() > 1.0;
    if (is_felt) most_N = std::max(most_N, (tick.hand_force_N.eigen() - tick.guide_force_N.eigen()).norm());
    return is_felt && tick.contact_force_uN.eigen().norm() > 2.0;
  }));
  EXPECT_FALSE(console_.may_replan());
  const double without_N = most_N;
  console_.haptics(true);
  EXPECT_TRUE(tick_until([&] {
    const HapticRecord tick = console_.status().tick;
    return (tick.hand_force_N.eigen() - tick.guide_force_N.eigen()).norm() > 2.0 * without_N + 0.05;
  }));
}

// A camera that stalls on command.
// The session has to know that its numbers are another cell's from here on.
TEST_F(OperatorConsoleTest, ANewCellIsANoteInTheSession) {
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  const auto new_cell = [&]() -> std::optional<Event> {
    for (const Event& event : run_.events_since(0))
      if (begins_new_cell(event)) return event;
    return std::nullopt;
  };
  EXPECT_FALSE(new_cell());
  console_.new_cell();
  ASSERT_TRUE(tick_until([&] { return new_cell().has_value(); }));
  // On the session's clock: about the time of the newest frame.
  EXPECT_NEAR(new_cell()->time_s, run_.scenes()->peek()->measurement.time_s, 5.0);
}

class StallingSource final : public FrameSource {
 public:
  StallingSource(std::unique_ptr<FrameSource> source, const std::atomic<bool>& stalled)
      : source_(std::move(source)), stalled_(stalled) {}
  const SourceInfo& info() const noexcept override { return source_->info(); }
  std::optional<Frame> next() override {
    while (stalled_) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return source_->next();
  }

 private:
  std::unique_ptr<FrameSource> source_;
  const std::atomic<bool>& stalled_;
};

// Blind, the pipette goes no deeper: whichever hand, at whichever scale.
TEST(OperatorConsole, WhatIsKnownOfTheCellOutlivesAChangeOfHand) {
  std::atomic<bool> stalled{false};
  VirtualInjectionSetup setup("injection");
  LiveRun run(std::make_unique<StallingSource>(setup.make_microscope(Pace::kWallClock), stalled), {});
  OperatorConsole console(run, setup.injector(), &setup.needle());
  const auto tick_until = [&](const std::function<bool(const HapticRecord&)>& condition) {
    for (int k = 0; k < 4500; ++k) {
      console.update();
      if (condition(console.status().tick)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  };
  run.start();
  console.choose(console.find_hand("Mouse").value());
  ASSERT_TRUE(tick_until([&](const HapticRecord&) { return console.plan().has_value(); }));
  console.scale(0);
  console.grip(true);
  const PlainVector3 axis = console.plan()->axis;
  EXPECT_TRUE(tick_until([](const HapticRecord& tick) { return tick.hand_state == HandState::kWorking; }));
  stalled = true;
  // So long that frames which a starved machine still had under way have arrived: each ends the blindness.
  constexpr double kNothingUnderWay_s = 3.0;
  const auto blind = [](const HapticRecord& tick) {
    return tick.contact_state == ContactState::kStale && tick.contact_age_s > kNothingUnderWay_s;
  };
  EXPECT_TRUE(tick_until(blind));

  const auto depth_um = [&] { return console.status().tick.tip_um.eigen().dot(axis.eigen()); };
  const auto push = [&](const char* change) {
    EXPECT_TRUE(tick_until(blind)) << change;
    console.grip(true);
    EXPECT_TRUE(tick_until([](const HapticRecord& tick) { return tick.hand_state == HandState::kWorking; })) << change;
    const double before_um = depth_um();
    for (int k = 0; k < 20; ++k) {
      console.move_px(5.0 * axis.x, 5.0 * axis.y);
      console.update();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_LT(depth_um(), before_um + 3.0) << change;
  };
  push("the same hand");
  console.scale(1);
  push("another scale");
  console.choose(console.find_hand("Mouse").value());
  push("another device");
  stalled = false;
  run.stop();
}

// A real cell: no demonstration on it, and it can't be replaced.
TEST(OperatorConsole, WithoutAVirtualNeedleThereIsNoDemonstration) {
  VirtualInjectionSetup setup("injection");
  LiveRun run(setup.make_microscope(Pace::kWallClock), {});
  const OperatorConsole console(run, setup.injector());
  EXPECT_FALSE(console.find_hand("Demonstration"));
  EXPECT_TRUE(console.find_hand("Mouse"));
  EXPECT_FALSE(console.can_renew());
}

}  // namespace
}  // namespace pellucida
