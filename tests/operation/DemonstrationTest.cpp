#include "ConsoleFixture.h"

namespace pellucida {
namespace {

using DemonstrationTest = OperatorConsoleTest;

TEST_F(DemonstrationTest, PlansTouchesBreaksDepositsAndBeginsAnew) {
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kWaiting);
  choose("Demonstration");
  EXPECT_TRUE(console_.is_demonstration());
  ASSERT_TRUE(tick_until([&] { return console_.plan().has_value(); }));
  EXPECT_GT(console_.plan()->depth_um, 20.0);
  EXPECT_NEAR(console_.depth_stop_um(), console_.plan()->depth_um + console_.plan()->options.overshoot_um, 1e-9);
  bool touched = false, punctured = false, deposited = false;
  ASSERT_TRUE(tick_until([&] {
    const HandStatus status = console_.status();
    // Measured, whether or not a busy machine let the hand feel it in time.
    touched = touched || run_.scenes()->peek()->contact.state == CellState::kContact;
    punctured = punctured || status.tick.contact_state == ContactState::kPunctured;
    deposited = deposited || (status.tick.buttons & kInject) != 0;
    return console_.doing().starts_with("Taking the needle out for");
  })) << console_.doing();
  EXPECT_TRUE(touched);
  EXPECT_TRUE(punctured);
  EXPECT_TRUE(deposited);
  // The next cell gets a plan of its own.
  ASSERT_TRUE(tick_until([&] { return !console_.plan(); }));
  EXPECT_TRUE(tick_until([&] { return console_.plan() && console_.doing() == "Approaching"; }));
  EXPECT_FALSE(console_.status().fault);
}

}  // namespace
}  // namespace pellucida
