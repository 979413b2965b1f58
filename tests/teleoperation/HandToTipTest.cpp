#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core/Clock.h"
#include "pellucida/haptics/HapticServo.h"
#include "pellucida/teleoperation/ManipulatorStage.h"
#include "pellucida/teleoperation/MouseHand.h"
#include "pellucida/teleoperation/SimulatedInjector.h"
#include "pellucida/teleoperation/TeleoperationMap.h"

// The whole way from a person's mouse to the pipette's tip, with the loop's own computation in between; time is turned
// by hand: a tick each millisecond, a turn of the manipulator each tenth.

namespace pellucida {
namespace {

const PlainVector3 kStart_um{100.0, 80.0, 0.0};

class HandToTip : public testing::Test {
 protected:
  HandToTip() { injector_.open(); }

  void run(double duration_s) {
    const int tick_count = static_cast<int>(std::lround(duration_s * 1000.0));
    for (int i = 0; i < tick_count; ++i) {
      clock_.advance(0.001);
      servo_.turn(clock_.now_s());
      if (++tick_ % 10 == 0) stage_.turn();
      if (!servo_.newest().refresh()) continue;
      mouse_.show(touch_cue(servo_.newest().value()));
    }
  }

  /// A frame in which the cell pushes the needle back along minus x.
  void touch(double force_uN, double depth_um) {
    ContactModel model;
    model.time_s = clock_.now_s();
    model.frame_index = ++frame_;
    model.valid = true;
    model.state = CellState::kContact;
    model.confidence = 1.0;
    model.tip_um = injector_.pose().tip_um;
    model.push = {1.0, 0.0, 0.0};
    model.force_uN = {-force_uN, 0.0, 0.0};
    model.stiffness_uN_per_um = force_uN / depth_um;
    model.depth_um = depth_um;
    contact_.publish(model);
  }

  Eigen::Vector3d tip_um() const { return injector_.pose().tip_um.eigen(); }

  static SimulatedInjectorOptions injector_options() {
    SimulatedInjectorOptions options;
    options.start_um = kStart_um;
    return options;
  }

  ManualClock clock_;
  MouseHand mouse_;
  TeleoperationMap map_;
  SimulatedInjector injector_{injector_options()};
  ManipulatorStage stage_{injector_, clock_};
  LatestValue<ContactModel> contact_;
  HapticServo servo_{mouse_, map_, HapticPorts{contact_, stage_.states(), stage_.commands()},
                     default_settings(mouse_.specification(), kFineScale_um_per_m)};
  long tick_ = 0, frame_ = 0;
};

TEST_F(HandToTip, NothingMovesUntilTheMouseDoes) {
  run(0.5);
  EXPECT_NEAR((tip_um() - kStart_um.eigen()).norm(), 0.0, 1e-9);
  EXPECT_GT(stage_.counts().command_count, 0u);
}

TEST_F(HandToTip, TheTipGoesWhereTheMouseGoes) {
  run(0.1);
  // 10 mm of the hand to the right and 5 mm down: 20 um and 10 um at 2000 um/m.
  for (int i = 0; i < 100; ++i) {
    mouse_.move_px(1.0, 0.5);
    run(0.005);
  }
  run(1.0);
  // Within backlash and step of the simulated injector.
  EXPECT_NEAR(tip_um().x(), kStart_um.x + 20.0, 0.3);
  EXPECT_NEAR(tip_um().y(), kStart_um.y + 10.0, 0.3);
  EXPECT_NEAR(tip_um().z(), kStart_um.z, 1e-9);
}

TEST_F(HandToTip, AClutchHoldsTheTipAndAStopHaltsIt) {
  run(0.1);
  mouse_.move_px(100.0, 0.0);
  run(1.0);
  const Eigen::Vector3d held_um = tip_um();
  mouse_.press(kClutch);
  run(0.05);
  mouse_.move_px(-300.0, 0.0);
  run(0.5);
  EXPECT_NEAR((tip_um() - held_um).norm(), 0.0, 1e-9);
  mouse_.release(kClutch);
  run(0.3);
  EXPECT_NEAR((tip_um() - held_um).norm(), 0.0, 1e-9);

  mouse_.press(kEmergency);
  run(0.05);
  EXPECT_TRUE(stage_.newest_state().stopped);
  mouse_.release(kEmergency);
  mouse_.move_px(200.0, 0.0);
  run(0.5);
  EXPECT_NEAR((tip_um() - held_um).norm(), 0.0, 1e-9);
}

TEST_F(HandToTip, ACellMakesTheMouseMoveLess) {
  run(0.1);
  for (int i = 0; i < 10; ++i) {
    touch(2.0, 10.0);
    run(0.03);
  }
  const double before_um = tip_um().x();
  for (int i = 0; i < 20; ++i) {
    mouse_.move_px(1.0, 0.0);
    touch(2.0, 10.0);
    run(0.03);
  }
  touch(2.0, 10.0);
  run(0.1);
  EXPECT_LT(mouse_.motion_ratio(), 0.8);
  EXPECT_GT(mouse_.motion_ratio(), 0.2);
  // 20 px would be 4 um in free motion.
  EXPECT_LT(tip_um().x() - before_um, 3.5);
  EXPECT_GT(tip_um().x() - before_um, 0.5);
}

TEST_F(HandToTip, ALostWindowHoldsThePipette) {
  run(0.1);
  mouse_.set_connected(false);
  mouse_.move_px(100.0, 0.0);
  run(0.5);
  EXPECT_NEAR((tip_um() - kStart_um.eigen()).norm(), 0.0, 1e-9);
  mouse_.set_connected(true);
  run(0.2);
  mouse_.move_px(100.0, 0.0);
  run(1.0);
  EXPECT_GT(tip_um().x() - kStart_um.x, 10.0);
}

TEST(TouchCue, ScalesTheContactOfATickToTheHand) {
  HapticRecord record;
  record.contact_state = ContactState::kContact;
  record.hand_state = HandState::kWorking;
  record.contact_force_uN = {0.0, -5.0, 0.0};
  record.depth_um = 10.0;
  record.scale_um_per_m = 2000.0;
  const TouchCue cue = touch_cue(record, 0.2);
  EXPECT_TRUE(cue.contact);
  // Up in the image is up at the hand.
  EXPECT_NEAR(cue.force_N.y, 1.0, 1e-12);
  EXPECT_NEAR(cue.stiffness_N_per_m, 0.5 * 0.2 * 2000.0, 1e-9);
  record.hand_state = HandState::kClutched;
  EXPECT_FALSE(touch_cue(record).contact);
}

}  // namespace
}  // namespace pellucida
