#include "pellucida/pipeline/HandDesk.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "pellucida/core/Error.h"
#include "pellucida/pipeline/VirtualWorkplace.h"

namespace pellucida {
namespace {

// A desk on the virtual microscope, its window's tick in the test's hands.
class HandDeskTest : public testing::Test {
 protected:
  HandDeskTest() { run_.start(); }
  ~HandDeskTest() override { run_.stop(); }

  // Ticks until the condition holds; a minute and a half is for a machine that is busy with other things.
  bool tick_until(const std::function<bool()>& condition) {
    for (int k = 0; k < 4500; ++k) {
      desk_.update();
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }
  bool tick_until_state(HandState state) {
    return tick_until([&] { return desk_.status().tick.hand_state == state; });
  }
  void choose(std::string_view name) { desk_.choose(desk_.find_hand(name).value()); }
  double tip_x_um() { return desk_.status().tick.tip_um.x; }

  VirtualWorkplace workplace_{"injection"};
  LiveRun run_{workplace_.make_microscope(Pace::kWallClock), {}};
  HandDesk desk_{run_, workplace_.injector(), &workplace_.needle(), {.rest_s = 0.5}};
};

TEST_F(HandDeskTest, TheDemonstrationPlansTouchesBreaksDepositsAndBeginsAnew) {
  EXPECT_EQ(desk_.status().tick.hand_state, HandState::kWaiting);
  choose("Demonstration");
  EXPECT_TRUE(desk_.is_demonstration());
  ASSERT_TRUE(tick_until([&] { return desk_.plan().has_value(); }));
  EXPECT_GT(desk_.plan()->depth_um, 20.0);
  EXPECT_NEAR(desk_.depth_stop_um(), desk_.plan()->depth_um + desk_.plan()->options.overshoot_um, 1e-9);
  bool touched = false, punctured = false, deposited = false;
  ASSERT_TRUE(tick_until([&] {
    const HandStatus status = desk_.status();
    // Measured, whether or not a busy machine let the hand feel it in time.
    touched = touched || run_.scenes()->peek()->contact.state == CellState::kContact;
    punctured = punctured || status.tick.contact_state == ContactState::kPunctured;
    deposited = deposited || (status.tick.buttons & kInject) != 0;
    return desk_.doing().starts_with("Needle out");
  })) << desk_.doing();
  EXPECT_TRUE(touched);
  EXPECT_TRUE(punctured);
  EXPECT_TRUE(deposited);
  // The next cell gets a plan of its own.
  ASSERT_TRUE(tick_until([&] { return !desk_.plan(); }));
  EXPECT_TRUE(tick_until([&] { return desk_.plan() && desk_.doing() == "Approaches"; }));
  EXPECT_FALSE(desk_.status().fault);
}

TEST_F(HandDeskTest, TheMouseLeadsOnlyWhileItHoldsTheNeedle) {
  choose("Mouse");
  ASSERT_TRUE(desk_.is_mouse());
  ASSERT_TRUE(tick_until_state(HandState::kClutched));
  const double start_um = tip_x_um();
  desk_.move_px(-50.0, 0.0);
  ASSERT_TRUE(tick_until([&] { return desk_.plan().has_value(); }));
  EXPECT_EQ(tip_x_um(), start_um);

  desk_.grip(true);
  ASSERT_TRUE(tick_until_state(HandState::kWorking));
  desk_.move_px(-50.0, 0.0);
  EXPECT_TRUE(tick_until([&] { return tip_x_um() < start_um - 5.0; }));

  // The window loses the focus: nothing is held any more.
  desk_.release_all();
  ASSERT_TRUE(tick_until_state(HandState::kClutched));
  const double left_um = tip_x_um();
  desk_.retract(true);
  EXPECT_TRUE(tick_until([&] { return tip_x_um() > left_um + 5.0; }));
  desk_.retract(false);
  EXPECT_TRUE(tick_until_state(HandState::kClutched));
}

TEST_F(HandDeskTest, TheGuideGoesAndTheDepthStopStays) {
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return desk_.plan().has_value(); }));
  desk_.guide(false);
  EXPECT_FALSE(desk_.guided());
  const InjectionPlan plan = *desk_.plan();
  desk_.depth_stop_um(12.0);
  EXPECT_EQ(desk_.depth_stop_um(), 12.0);
  EXPECT_THROW(desk_.depth_stop_um(0.0), UsageError);
  desk_.scale(0);
  desk_.grip(true);
  // Far past the cell: the tip stands 12 um behind the entry.
  const auto depth_um = [&] {
    return (desk_.status().tick.tip_um.eigen() - plan.entry_um.eigen()).dot(plan.axis.eigen());
  };
  ASSERT_TRUE(tick_until([&] {
    desk_.move_px(4.0 * plan.axis.x, 4.0 * plan.axis.y);
    return (desk_.status().tick.fixtures & kStopBit) != 0 && depth_um() > 8.0;
  }));
  for (int k = 0; k < 20; ++k) {
    desk_.move_px(4.0 * plan.axis.x, 4.0 * plan.axis.y);
    desk_.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_LT(depth_um(), 14.0);
}

TEST_F(HandDeskTest, AnEmergencyStopOutlivesTheHand) {
  choose("Mouse");
  desk_.grip(true);
  ASSERT_TRUE(tick_until_state(HandState::kWorking));
  desk_.emergency_stop(true);
  ASSERT_TRUE(tick_until_state(HandState::kStopped));
  choose("Mouse");
  ASSERT_TRUE(tick_until([&] { return desk_.status().tick_count > 20; }));
  EXPECT_EQ(desk_.status().tick.hand_state, HandState::kStopped);
  desk_.emergency_stop(false);
  EXPECT_TRUE(tick_until_state(HandState::kClutched));
}

TEST_F(HandDeskTest, ATargetOutsideTheCellIsRefusedWithItsReason) {
  choose("Mouse");
  EXPECT_TRUE(desk_.set_target(0.0, 0.0)) << "no plan yet";
  ASSERT_TRUE(tick_until([&] { return desk_.plan().has_value(); }));
  const PlainVector3 center_um = desk_.plan()->cell.center_um;
  const auto refused = desk_.set_target(center_um.x + 500.0, center_um.y);
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->find("outside"), std::string::npos) << *refused;
  EXPECT_FALSE(desk_.set_target(center_um.x, center_um.y + 8.0));
  EXPECT_NEAR(desk_.plan()->target_um.y, center_um.y + 8.0, 1.0);
}

TEST_F(HandDeskTest, NumbersOutOfRangeAreRefused) {
  EXPECT_THROW(desk_.choose(-1), UsageError);
  EXPECT_THROW(desk_.choose(99), UsageError);
  EXPECT_THROW(desk_.scale(3), UsageError);
  EXPECT_FALSE(desk_.find_hand("no such hand"));
}

// A real cell: nobody may demonstrate on it, and it can't be renewed.
TEST(HandDesk, WithoutAVirtualNeedleThereIsNoDemonstration) {
  VirtualWorkplace workplace("injection");
  LiveRun run(workplace.make_microscope(Pace::kWallClock), {});
  const HandDesk desk(run, workplace.injector());
  EXPECT_FALSE(desk.find_hand("Demonstration"));
  EXPECT_TRUE(desk.find_hand("Mouse"));
  EXPECT_FALSE(desk.can_renew());
}

}  // namespace
}  // namespace pellucida
