// Faults in the middle of a push: what the hand feels and what the pipette is commanded stay continuous, with a bounded
// slope, and are where they belong within the stated time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/HandRun.h"
#include "pellucida/haptics/DeviceCatalog.h"

namespace pellucida {
namespace {

constexpr double kScale_um_per_m = 2000.0;

class Fault : public testing::Test {
 protected:
  Fault() : device_(find_device("Touch")), settings_(make_settings()), run_(device_, settings_, kScale_um_per_m) {
    run_.cell.contact_x_um = 20.0;
    // Pushes to some 30 um depth and stays there.
    for (int k = 0; k < 2000; ++k) {
      run_.arm.intent_m.x() = 0.03 * std::min(1.0, 1e-3 * k);
      run_.tick();
    }
    before_ = run_.tick();
    run_.events();
  }

  HapticSettings make_settings() const {
    HapticSettings settings = default_settings(device_, kScale_um_per_m);
    settings.predictor.tip_lag_s = 0.03;
    return settings;
  }

  double force_slope_N() const {
    // The force may change by the device's largest in full_scale_time_s.
    return device_.max_force_N * settings_.period_s / settings_.full_scale_time_s * 1.0001;
  }
  double tip_slope_um() const { return settings_.limits.max_speed_um_per_s * settings_.period_s * 1.0001; }

  // All that always holds.
  void expect_smooth(std::vector<HapticRecord> records) {
    records.insert(records.begin(), before_);
    EXPECT_LE(test::largest_force_step_N(records), force_slope_N());
    EXPECT_LE(test::largest_tip_step_um(records), tip_slope_um());
    for (const HapticRecord& record : records) {
      ASSERT_TRUE(record.hand_force_N.eigen().allFinite());
      ASSERT_LE(record.hand_force_N.eigen().norm(), device_.max_force_N * (1.0 + 1e-12));
    }
  }

  // Seconds after the first record until the force is, and stays, below a hundredth of a newton.
  static double gone_after_s(const std::vector<HapticRecord>& records) {
    std::size_t last = 0;
    for (std::size_t k = 0; k < records.size(); ++k) {
      if (records[k].hand_force_N.eigen().norm() > 0.01) last = k + 1;
    }
    return 1e-3 * static_cast<double>(last);
  }

  bool reported(LimitKind kind) {
    const auto events = run_.events();
    return std::any_of(events.begin(), events.end(), [&](const LimitEvent& e) { return e.kind == kind && e.begun; });
  }

  DeviceSpecification device_;
  HapticSettings settings_;
  test::HandRun run_;
  HapticRecord before_;
};

TEST_F(Fault, BeforeAnyThePushIsFelt) {
  EXPECT_EQ(before_.hand_state, HandState::kWorking);
  EXPECT_EQ(before_.contact_state, ContactState::kContact);
  EXPECT_LT(before_.hand_force_N.x, -0.3);
  const double truth_uN = run_.cell.force_at(run_.cell.depth_um(run_.pipette_x_um()));
  EXPECT_NEAR(before_.contact_force_uN.x, -truth_uN, 4e-6 * truth_uN);
}

TEST_F(Fault, TheCameraStalls) {
  run_.camera_stalled = true;
  const auto records = run_.run(0.5);
  expect_smooth(records);
  // The last frames arrive 20 ms after; then the age limit and the fading: zero within their sum.
  EXPECT_LE(gone_after_s(records), 0.035 + settings_.predictor.age_limit_s + settings_.predictor.stale_time_s + 0.01);
  EXPECT_EQ(records.back().contact_state, ContactState::kStale);
  EXPECT_TRUE(reported(LimitKind::kContactStale));
  EXPECT_EQ(records.back().hand_state, HandState::kWorking) << "the hand still leads the pipette";
  // And comes back with frames, as smoothly.
  run_.camera_stalled = false;
  before_ = records.back();
  const auto after = run_.run(1.0);
  expect_smooth(after);
  EXPECT_LT(after.back().hand_force_N.x, -0.3);
}

TEST_F(Fault, BlindThePipetteGoesNoDeeperButComesBackAtOnce) {
  run_.camera_stalled = true;
  auto records = run_.run(0.7);
  // The force is gone and the person pushes on: after a quarter of a second the pipette goes no deeper.
  run_.arm.intent_m.x() += 0.01;
  const auto pushed = run_.run(0.8);
  records.insert(records.end(), pushed.begin(), pushed.end());
  const auto stale = std::find_if(records.begin(), records.end(), [&](const HapticRecord& record) {
    return record.contact_age_s > settings_.limits.blind_age_s + 0.002;
  });
  ASSERT_NE(stale, records.end());
  for (auto record = stale; record != records.end(); ++record) {
    ASSERT_LE(record->tip_um.x, stale->tip_um.x + 1e-9);
    EXPECT_EQ(record->hand_state, HandState::kWorking);
  }
  EXPECT_GT(run_.arm.position_m().x(), before_.hand_m.x + 1e-3);
  EXPECT_TRUE(reported(LimitKind::kBlind));
  // A small way back is a small way back of the pipette, wherever the hand had gone.
  run_.run(1.0);
  before_ = run_.tick();
  run_.arm.intent_m.x() = run_.arm.position_m().x() - 0.004;
  const auto back = run_.run(1.0);
  expect_smooth(back);
  EXPECT_LT(back.back().tip_um.x, before_.tip_um.x - 4.0);
  EXPECT_GT(back.back().tip_um.x, before_.tip_um.x - 12.0);
  // Unless it's switched off.
  settings_.limits.blind_age_s = std::numeric_limits<double>::infinity();
  run_.servo().set(settings_);
  run_.arm.intent_m.x() += 0.01;
  EXPECT_GT(run_.run(1.0).back().tip_um.x, back.back().tip_um.x + 15.0);
}

// Another scale or device while the camera has stalled: the new hand knows no more of the cell than the old one did.
TEST_F(Fault, BlindAnotherHandMayNotPushEither) {
  run_.camera_stalled = true;
  const double tip_um = run_.run(0.5).back().tip_um.x;
  run_.change_hand();
  EXPECT_EQ(run_.run(0.1).back().contact_state, ContactState::kStale);
  run_.arm.intent_m.x() += 0.01;
  for (const HapticRecord& record : run_.run(0.8)) ASSERT_LE(record.tip_um.x, tip_um + 1.0);
  EXPECT_TRUE(reported(LimitKind::kBlind));
  EXPECT_GT(run_.arm.position_m().x(), before_.hand_m.x + 1e-3) << "the hand itself went on";
  // Back is free.
  run_.arm.intent_m.x() = run_.arm.position_m().x() - 0.01;
  EXPECT_LT(run_.run(1.0).back().tip_um.x, tip_um - 8.0);
}

// The same with a contact that lasts: nothing is felt at once, and no step either.
TEST_F(Fault, AnotherHandFeelsTheContactFadeIn) {
  run_.change_hand();
  const auto records = run_.run(0.5);
  EXPECT_EQ(records.front().contact_state, ContactState::kContact);
  EXPECT_LT(records.front().hand_force_N.eigen().norm(), 1e-9);
  for (const HapticRecord& record : records) ASSERT_NEAR(record.pipette_um.x, before_.pipette_um.x, 13.0);
  before_ = records.front();
  expect_smooth(records);
  EXPECT_LT(records.back().hand_force_N.x, -0.1);
}

TEST_F(Fault, TheModelSaysNaN) {
  run_.camera_says_nan = true;
  const auto records = run_.run(0.5);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), 0.06 + settings_.predictor.invalid_time_s + 0.01);
  EXPECT_TRUE(reported(LimitKind::kContactInvalid));
}

TEST_F(Fault, TheDeviceIsLost) {
  run_.arm.lost = true;
  const auto records = run_.run(0.3);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), settings_.release_time_s + 0.005);
  EXPECT_EQ(records.back().hand_state, HandState::kHeld);
  EXPECT_EQ(run_.command().max_speed_um_per_s, 0.0) << "the pipette is at rest";
  EXPECT_EQ(records.back().tip_um.x, before_.tip_um.x) << "where it was";
  EXPECT_TRUE(reported(LimitKind::kHandLost));
  // It comes back elsewhere: the pipette doesn't follow that.
  run_.arm.intent_m.x() = -0.01;
  for (int k = 0; k < 500; ++k) run_.arm.advance(1e-3);
  run_.arm.lost = false;
  before_ = records.back();
  const auto after = run_.run(0.3);
  expect_smooth(after);
  EXPECT_NEAR(after.front().tip_um.x, before_.tip_um.x, 1e-9);
  EXPECT_EQ(after.back().hand_state, HandState::kWorking);
}

TEST_F(Fault, TheHandSaysNaN) {
  run_.arm.says_nan = true;
  const auto records = run_.run(0.1);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), settings_.release_time_s + 0.005);
  EXPECT_TRUE(reported(LimitKind::kHandInvalid));
}

TEST_F(Fault, TheReadingJumps) {
  run_.arm.jump_m.x() = 0.05;
  const auto records = run_.run(0.2);
  expect_smooth(records);
  EXPECT_TRUE(reported(LimitKind::kHandJump));
  for (const HapticRecord& record : records) ASSERT_NEAR(record.tip_um.x, before_.tip_um.x, 4e-4) << "100 um of jump";
}

TEST_F(Fault, TicksComeLate) {
  std::vector<HapticRecord> records;
  // The hand goes on while the loop sleeps for 40 ms, five times.
  for (int late = 0; late < 5; ++late) {
    run_.arm.intent_m.x() -= 0.002;
    records.push_back(run_.tick(0.04));
    for (int k = 0; k < 50; ++k) records.push_back(run_.tick());
  }
  // A late tick may carry 40 ms of speed, but it's tied anew: no more than an ordinary tick's way and force.
  expect_smooth(records);
  EXPECT_TRUE(reported(LimitKind::kLateTick));
}

TEST_F(Fault, TheMembraneGivesWay) {
  run_.cell.punctured = true;
  const auto records = run_.run(0.3);
  expect_smooth(records);
  // From the frame that reports it.
  const auto reported_at = std::find_if(records.begin(), records.end(), [](const HapticRecord& record) {
    return record.contact_state == ContactState::kPunctured;
  });
  ASSERT_NE(reported_at, records.end());
  const std::vector<HapticRecord> after(reported_at, records.end());
  EXPECT_LE(gone_after_s(after), settings_.predictor.release_time_s + 0.004);
  // No kick: the force goes down only, and never pulls the hand into the cell.
  for (std::size_t k = 1; k < after.size(); ++k) {
    EXPECT_LE(after[k].hand_force_N.eigen().norm(), after[k - 1].hand_force_N.eigen().norm() + 1e-9);
    EXPECT_LE(after[k].hand_force_N.x, 1e-9);
  }
  EXPECT_TRUE(reported(LimitKind::kPuncture));
}

// The arm that leaned on the membrane falls forward; the pipette stays, goes back at once, and on when the time is
// over.
TEST_F(Fault, ThePipetteDoesNotFallIntoThePuncturedCell) {
  run_.cell.punctured = true;
  std::vector<HapticRecord> records;
  do {
    ASSERT_LT(records.size(), 200U) << "the puncture was never reported";
    records.push_back(run_.tick());
  } while (records.back().contact_state != ContactState::kPunctured);
  const double tip_um = records.back().tip_um.x;
  const double hand_m = records.back().hand_m.x;

  run_.arm.intent_m.x() += 0.005;
  for (const HapticRecord& record : run_.run(0.9 * settings_.limits.puncture_hold_s)) {
    records.push_back(record);
    EXPECT_LE(record.tip_um.x, tip_um + 1.0);
  }
  EXPECT_GT(records.back().hand_m.x, hand_m + 0.003);

  const double held_um = records.back().tip_um.x;
  run_.arm.intent_m.x() -= 0.010;
  const auto back = run_.run(0.3);
  EXPECT_LT(back.back().tip_um.x, held_um - 10.0);
  run_.arm.intent_m.x() += 0.005;
  const auto on = run_.run(0.5);
  EXPECT_GT(on.back().tip_um.x, back.back().tip_um.x + 10.0);
  records.insert(records.end(), back.begin(), back.end());
  records.insert(records.end(), on.begin(), on.end());
  expect_smooth(records);
}

// The hold is the cell's, not the hand's: a change of hand doesn't end it.
TEST_F(Fault, AfterAPunctureAnotherHandIsHeldBackToo) {
  run_.cell.punctured = true;
  HapticRecord record;
  for (int k = 0; k < 200 && record.contact_state != ContactState::kPunctured; ++k) record = run_.tick();
  ASSERT_EQ(record.contact_state, ContactState::kPunctured);
  const double tip_um = record.tip_um.x;
  run_.camera_stalled = true;
  run_.change_hand();
  run_.arm.intent_m.x() += 0.01;
  for (const HapticRecord& after : run_.run(0.9 * settings_.limits.puncture_hold_s)) {
    ASSERT_LE(after.tip_um.x, tip_um + 1.0);
  }
  EXPECT_GT(run_.arm.position_m().x(), record.hand_m.x + 3e-3);
  // The hold ends when it would have without the change.
  const double held_um = run_.run(0.2 * settings_.limits.puncture_hold_s).back().tip_um.x;
  run_.arm.intent_m.x() += 0.005;
  EXPECT_GT(run_.run(0.5).back().tip_um.x, held_um + 5.0);
}

TEST_F(Fault, TheForceDropsThoughTheStateSaysContact) {
  run_.cell.force_uN *= 0.2;
  const auto records = run_.run(0.3);
  expect_smooth(records);
  EXPECT_TRUE(reported(LimitKind::kPuncture));
}

TEST_F(Fault, TheManipulatorIsLost) {
  run_.pipette_lost = true;
  const auto records = run_.run(0.3);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), settings_.release_time_s + 0.005);
  EXPECT_EQ(run_.command().max_speed_um_per_s, 0.0);
  EXPECT_TRUE(reported(LimitKind::kPipetteLost));
}

TEST_F(Fault, TheEmergencyStopWinsAndStays) {
  run_.servo().emergency_stop();
  run_.servo().release_emergency_stop();
  auto records = run_.run(0.2);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), settings_.release_time_s + 0.005);
  EXPECT_TRUE(run_.command().stop) << "asked for both at once, the stop wins";
  EXPECT_EQ(records.back().hand_state, HandState::kStopped);
  // The hand moves; the pipette doesn't.
  run_.arm.intent_m.x() = 0.0;
  records = run_.run(0.5);
  EXPECT_TRUE(run_.command().stop);
  EXPECT_NEAR(records.back().tip_um.x, records.front().tip_um.x, 1e-12);
  EXPECT_TRUE(reported(LimitKind::kEmergencyStop));
  // Released on purpose, from where pipette and hand are.
  before_ = records.back();
  run_.servo().release_emergency_stop();
  records = run_.run(0.5);
  expect_smooth(records);
  EXPECT_FALSE(run_.command().stop);
  EXPECT_EQ(records.back().hand_state, HandState::kWorking);
}

TEST_F(Fault, TheEmergencyButtonHoldsAgainstARelease) {
  run_.arm.buttons = kEmergency;
  run_.run(0.1);
  run_.servo().release_emergency_stop();
  run_.run(0.1);
  EXPECT_TRUE(run_.command().stop) << "the button is still pressed";
}

TEST_F(Fault, TheClutchLeavesThePipetteAndTakesTheForce) {
  run_.arm.buttons = kClutch;
  const auto records = run_.run(0.3);
  expect_smooth(records);
  EXPECT_LE(gone_after_s(records), settings_.clutch_time_s + 0.01);
  run_.arm.intent_m.x() = -0.02;
  run_.run(0.5);
  run_.arm.buttons = 0;
  const HapticRecord back = run_.tick();
  EXPECT_NEAR(back.tip_um.x, records.front().tip_um.x, 1e-9) << "the hand was moved back, the pipette wasn't";
}

TEST_F(Fault, TheRetractButtonTakesThePipetteOut) {
  run_.arm.buttons = kRetract;
  const auto records = run_.run(0.5);
  expect_smooth(records);
  EXPECT_NEAR(records.back().tip_um.x, before_.tip_um.x - 0.5 * settings_.limits.retract_speed_um_per_s, 1e-9);
}

TEST_F(Fault, ChangedFixturesFadeOver) {
  settings_.fixtures.stop.enabled = true;
  settings_.fixtures.stop.entry_um = PlainVector3(20.0, 0.0, 0.0);
  settings_.fixtures.stop.depth_um = 5.0;  // far behind where the tip is
  run_.servo().set(settings_);
  const auto records = run_.run(1.0);
  expect_smooth(records);
  // Far below the guard's own slope: the fixture comes in over a tenth of a second.
  EXPECT_LE(test::largest_force_step_N(records), 0.1);
  EXPECT_LT(records.back().tip_um.x, 27.0) << "the stop holds";
  EXPECT_TRUE(records.back().fixtures & kStopBit);
}

TEST_F(Fault, AStrikeStaysWithinTheLimitsAndCalmsDown) {
  // Out of contact, then the hand strikes into the cell between two frames.
  run_.arm.intent_m.x() = -0.02;
  run_.run(1.0);
  run_.arm.intent_m.x() = 0.05;
  before_ = run_.tick();
  const auto strike = run_.run(3.0);
  expect_smooth(strike);
  const auto calm = run_.run(1.0);
  double low = 1e9, high = -1e9;
  for (const HapticRecord& record : calm) {
    low = std::min(low, record.hand_m.x);
    high = std::max(high, record.hand_m.x);
  }
  EXPECT_LT(high - low, 1e-9);
}

}  // namespace
}  // namespace pellucida
