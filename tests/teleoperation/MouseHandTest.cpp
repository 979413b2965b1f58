#include "pellucida/teleoperation/MouseHand.h"

#include <gtest/gtest.h>

#include <limits>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

TouchCue contact_along_x(double stiffness_N_per_m) {
  TouchCue cue;
  cue.contact = true;
  cue.force_N = {-1.0, 0.0, 0.0};
  cue.stiffness_N_per_m = stiffness_N_per_m;
  return cue;
}

/// Reads on, a millisecond a time, until the smoothing has come to rest.
void settle(MouseHand& mouse, double& time_s, HandSample& hand) {
  for (int i = 0; i < 400; ++i) ASSERT_TRUE(mouse.read(time_s += 0.001, hand));
}

TEST(MouseHand, PointerMovesInTheImagePlaneAndTheWheelInDepth) {
  MouseHand mouse;
  HandSample hand;
  double time_s = 0.0;
  settle(mouse, time_s, hand);
  mouse.move_px(10.0, 0.0);
  mouse.move_px(0.0, 20.0);
  mouse.turn_wheel(2.0);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.x, 0.001, 1e-9);
  EXPECT_NEAR(hand.position_m.y, -0.002, 1e-9);
  EXPECT_NEAR(hand.position_m.z, -0.001, 1e-9);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.x, 0.001, 1e-9);
}

TEST(MouseHand, AStepOfTheMouseBecomesAMoveAHandCanMake) {
  MouseHand mouse;
  HandSample hand;
  double time_s = 0.0;
  settle(mouse, time_s, hand);
  mouse.move_px(1500.0, 0.0);
  double last_m = hand.position_m.x;
  for (int i = 0; i < 1000; ++i) {
    mouse.read(time_s += 0.001, hand);
    ASSERT_LE(hand.position_m.x - last_m, 0.001 * HandSmoother::kMaxSpeed_m_per_s + 1e-12);
    ASSERT_TRUE(hand.velocity_known);
    ASSERT_NEAR(hand.velocity_m_per_s.x, (hand.position_m.x - last_m) / 0.001, 1e-6);
    last_m = hand.position_m.x;
  }
  EXPECT_NEAR(hand.position_m.x, 0.15, 1e-9);
}

TEST(MouseHand, KeysMoveAtASpeedAndDoNotLeapAfterAGap) {
  MouseHand mouse;
  HandSample hand;
  mouse.read(0.0, hand);
  mouse.steer({0.0, 1.0, 0.0});
  for (int i = 1; i <= 1000; ++i) mouse.read(0.001 * i, hand);
  // 10 mm/s for a second, less the lag of the smoothing.
  EXPECT_NEAR(hand.position_m.y, 0.01 - 0.01 * HandSmoother::kLag_s, 1e-5);
  mouse.steer({});
  mouse.read(60.0, hand);
  double time_s = 60.0;
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.y, 0.01, 1e-9);
  mouse.steer({0.0, 1.0, 0.0});
  mouse.read(time_s += 60.0, hand);
  mouse.steer({});
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.y, 0.011, 1e-9);
}

TEST(MouseHand, ButtonsAreHeldUntilReleasedOrTheFocusGoes) {
  MouseHand mouse;
  HandSample hand;
  mouse.press(kClutch);
  mouse.press(kInject);
  mouse.read(0.0, hand);
  EXPECT_EQ(hand.buttons, kClutch | kInject);
  mouse.release(kClutch);
  mouse.read(0.001, hand);
  EXPECT_EQ(hand.buttons, static_cast<std::uint32_t>(kInject));
  mouse.steer({1.0, 0.0, 0.0});
  mouse.release_all();
  mouse.read(0.002, hand);
  mouse.read(0.003, hand);
  EXPECT_EQ(hand.buttons, 0u);
  EXPECT_EQ(hand.position_m.x, 0.0);
}

TEST(MouseHand, TheStifferTheContactTheLessItMovesAlongTheForceOnly) {
  MouseHand mouse;
  HandSample hand;
  double time_s = 0.0;
  settle(mouse, time_s, hand);
  mouse.show(contact_along_x(100.0));
  mouse.move_px(10.0, 10.0);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(mouse.motion_ratio(), 0.5, 1e-12);
  EXPECT_NEAR(hand.position_m.x, 0.0005, 1e-9);
  EXPECT_NEAR(hand.position_m.y, -0.001, 1e-9);
  mouse.show(contact_along_x(300.0));
  mouse.move_px(10.0, 0.0);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.x, 0.0005 + 0.00025, 1e-9);
  // Free again: the whole motion.
  mouse.show({});
  mouse.move_px(10.0, 0.0);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.x, 0.00075 + 0.001, 1e-9);
}

TEST(MouseHand, StaysInItsWorkspaceAndIgnoresWhatIsNotANumber) {
  MouseHand mouse;
  HandSample hand;
  double time_s = 0.0;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  mouse.move_px(nan, 0.0);
  mouse.steer({nan, 0.0, 0.0});
  mouse.show(contact_along_x(nan));
  mouse.move_px(1e9, 0.0);
  settle(mouse, time_s, hand);
  EXPECT_NEAR(hand.position_m.x, mouse.specification().workspace_radius_m, 1e-9);
}

TEST(MouseHand, IsLostWhenTheWindowGoesAndComesBack) {
  MouseHand mouse;
  HandSample hand;
  EXPECT_TRUE(mouse.read(0.0, hand));
  mouse.set_connected(false);
  EXPECT_FALSE(mouse.read(0.001, hand));
  EXPECT_FALSE(mouse.write({}));
  mouse.set_connected(true);
  EXPECT_TRUE(mouse.read(0.002, hand));
  EXPECT_TRUE(mouse.write({}));
  EXPECT_EQ(mouse.specification().max_force_N, 0.0);
}

TEST(MouseHand, RefusesOptionsThatMeanNothing) {
  EXPECT_THROW(MouseHand({.m_per_px = 0.0}), UsageError);
}

}  // namespace
}  // namespace pellucida
