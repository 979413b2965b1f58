#include "pellucida/teleoperation/TeleoperationMap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using Control = TeleoperationSettings::Control;
constexpr double kTick_s = 0.001;

HandSample hand_at(double x_m, double y_m = 0.0, double z_m = 0.0, std::uint32_t buttons = 0) {
  HandSample hand;
  hand.position_m = {x_m, y_m, z_m};
  hand.buttons = buttons;
  return hand;
}

TremorOptions no_filter() {
  TremorOptions options;
  options.enabled = false;
  return options;
}

TeleoperationSettings rate_settings() {
  TeleoperationSettings settings;
  settings.control = Control::kRate;
  return settings;
}

double distance_um(const PlainVector3& a, const PlainVector3& b) {
  return (a.eigen() - b.eigen()).norm();
}

TEST(TeleoperationMap, EngagesWithoutAJumpWhereverTheHandIs) {
  for (const auto& settings : {TeleoperationSettings{}, rate_settings()}) {
    TeleoperationMap map(settings);
    const PlainVector3 tip_um{120.0, 80.0, -5.0};
    map.engage(hand_at(0.07, -0.03, 0.01), tip_um);
    const TipTarget first = map.update(hand_at(0.071, -0.03, 0.01), kTick_s);
    EXPECT_EQ(distance_um(first.tip_um, tip_um), 0.0);
    EXPECT_FALSE(first.clutched);
  }
}

TEST(TeleoperationMap, ScalesAndTurnsTheThreeAxesAtOnce) {
  TeleoperationMap map({}, no_filter());
  map.engage(hand_at(0.0), {10.0, 20.0, 30.0});
  map.update(hand_at(0.0), kTick_s);
  const TipTarget target = map.update(hand_at(0.001, 0.002, 0.003), kTick_s);
  // Frame H is right, up, towards the person; frame W is right, down, into the scene.
  EXPECT_NEAR(target.tip_um.x, 10.0 + 2.0, 1e-12);
  EXPECT_NEAR(target.tip_um.y, 20.0 - 4.0, 1e-12);
  EXPECT_NEAR(target.tip_um.z, 30.0 - 6.0, 1e-12);
  EXPECT_NEAR(target.velocity_um_per_s.y, -4000.0, 1e-9);
}

TEST(TeleoperationMap, ClutchHoldsTheTipAndLetsGoWithoutAJump) {
  for (const auto& tremor : {TremorOptions{}, no_filter()}) {
    TeleoperationMap map({}, tremor);
    map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
    TipTarget target;
    for (int i = 0; i < 200; ++i) target = map.update(hand_at(0.0001 * i), kTick_s);
    const PlainVector3 held_um = target.tip_um;
    ASSERT_GT(held_um.x, 10.0);

    // The hand goes 50 mm back with the clutch held.
    for (int i = 0; i < 100; ++i) {
      target = map.update(hand_at(0.02 - 0.0005 * i, 0.0, 0.0, kClutch), kTick_s);
      EXPECT_TRUE(target.clutched);
      EXPECT_EQ(distance_um(target.tip_um, held_um), 0.0);
      EXPECT_EQ(target.velocity_um_per_s.eigen().norm(), 0.0);
    }
    const double let_go_m = 0.02 - 0.0005 * 99;
    target = map.update(hand_at(let_go_m), kTick_s);
    EXPECT_FALSE(target.clutched);
    EXPECT_EQ(distance_um(target.tip_um, held_um), 0.0);

    // A hand that rests leaves the tip where it is; one that moves takes it along.
    for (int i = 0; i < 500; ++i) target = map.update(hand_at(let_go_m), kTick_s);
    EXPECT_NEAR(distance_um(target.tip_um, held_um), 0.0, 1e-9);
    for (int i = 0; i < 2000; ++i) target = map.update(hand_at(let_go_m + 0.001), kTick_s);
    EXPECT_NEAR(target.tip_um.x - held_um.x, 2.0, 1e-9);
  }
}

TEST(TeleoperationMap, ChangesScaleWithoutAJumpEvenInMotion) {
  TeleoperationMap map;
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  TipTarget before;
  int i = 0;
  for (; i < 500; ++i) before = map.update(hand_at(2e-5 * i), kTick_s);
  TeleoperationSettings coarse;
  coarse.scale_um_per_m = kCoarseScale_um_per_m;
  map.request(coarse);
  const TipTarget after = map.update(hand_at(2e-5 * i), kTick_s);
  EXPECT_EQ(map.scale_um_per_m(), kCoarseScale_um_per_m);
  // No more than a tick's motion at the new scale: 20 mm/s of the hand are 0.2 um a tick.
  EXPECT_LT(distance_um(after.tip_um, before.tip_um), 0.21);
  EXPECT_GT(after.tip_um.x, before.tip_um.x);
}

TEST(TeleoperationMap, SwitchesTheTremorFilterWithoutAJumpEvenInMotion) {
  TeleoperationMap map;
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  int i = 0;
  for (const bool enabled : {false, true, false}) {
    TipTarget before;
    for (int k = 0; k < 500; ++k) before = map.update(hand_at(2e-5 * i++), kTick_s);
    TremorOptions tremor;
    tremor.enabled = enabled;
    map.request({}, tremor);
    const TipTarget after = map.update(hand_at(2e-5 * i++), kTick_s);
    EXPECT_EQ(map.lag_s() > 0.0, enabled);
    // No more than two ticks' motion: 20 mm/s of the hand are 0.04 um a tick.
    EXPECT_LT(distance_um(after.tip_um, before.tip_um), 0.08);
  }
  // The next request without a filter named keeps the last.
  map.request({});
  map.update(hand_at(2e-5 * i), kTick_s);
  EXPECT_EQ(map.lag_s(), 0.0);
}

TEST(TeleoperationMap, ChangesControlWithoutAJump) {
  TeleoperationMap map({}, no_filter());
  map.engage(hand_at(0.0), {5.0, 5.0, 5.0});
  map.update(hand_at(0.0), kTick_s);
  TipTarget before = map.update(hand_at(0.03), kTick_s);
  map.request(rate_settings());
  TipTarget after = map.update(hand_at(0.03), kTick_s);
  EXPECT_EQ(distance_um(after.tip_um, before.tip_um), 0.0);
  after = map.update(hand_at(0.04), kTick_s);
  EXPECT_GT(after.velocity_um_per_s.x, 0.0);
  before = after;
  map.request({});
  after = map.update(hand_at(0.04), kTick_s);
  EXPECT_EQ(distance_um(after.tip_um, before.tip_um), 0.0);
}

TEST(TeleoperationMap, TremorReachesTheTipAsTheFilterLeavesIt) {
  TeleoperationMap map;
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  double lowest_um = 0.0, highest_um = 0.0;
  for (int tick = 0; tick <= 5000; ++tick) {
    const double tremor_m = 1e-4 * std::sin(2.0 * std::numbers::pi * 10.0 * tick * kTick_s);
    const TipTarget target = map.update(hand_at(0.0, tremor_m), kTick_s);
    if (tick < 2000) continue;
    lowest_um = std::min(lowest_um, target.tip_um.y);
    highest_um = std::max(highest_um, target.tip_um.y);
  }
  // 100 um at the hand are 0.2 um at the tip unfiltered.
  EXPECT_LT((highest_um - lowest_um) / 2.0, 0.12 * 0.2);
  EXPECT_GT((highest_um - lowest_um) / 2.0, 0.05 * 0.2);
  EXPECT_NEAR(map.lag_s(), 0.075, 4e-4);
}

TEST(TeleoperationMap, RateControlHasADeadZoneAndStartsFromZeroAtItsEdge) {
  TeleoperationMap map(rate_settings(), no_filter());
  map.engage(hand_at(0.01), {0.0, 0.0, 0.0});
  map.update(hand_at(0.01), kTick_s);
  TipTarget target;
  for (int i = 0; i < 100; ++i) target = map.update(hand_at(0.01 + 0.0019), kTick_s);
  EXPECT_EQ(target.tip_um.x, 0.0);
  target = map.update(hand_at(0.01 + 0.0021), kTick_s);
  EXPECT_NEAR(target.velocity_um_per_s.x, 4000.0 * 0.0001, 1e-9);
  target = map.update(hand_at(0.01 + 0.012), kTick_s);
  EXPECT_NEAR(target.velocity_um_per_s.x, 4000.0 * 0.010, 1e-9);
}

TEST(TeleoperationMap, RateControlMovesAtItsSpeed) {
  TeleoperationMap map(rate_settings(), no_filter());
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  map.update(hand_at(0.0), kTick_s);
  TipTarget target;
  for (int i = 0; i < 1000; ++i) target = map.update(hand_at(0.012, 0.0, 0.0), kTick_s);
  EXPECT_NEAR(target.tip_um.x, 40.0, 1e-6);
}

TEST(TeleoperationMap, ASelfCentringDeviceMustRestBeforeItMovesTheTip) {
  TeleoperationSettings settings = rate_settings();
  settings.self_centring = true;
  TeleoperationMap map(settings, no_filter());
  // Engaged with the stick pushed: nothing moves until it has been released once.
  map.engage(hand_at(0.015), {1.0, 0.0, 0.0});
  TipTarget target;
  for (int i = 0; i < 100; ++i) target = map.update(hand_at(0.015), kTick_s);
  EXPECT_EQ(target.tip_um.x, 1.0);
  map.update(hand_at(0.0), kTick_s);
  for (int i = 0; i < 100; ++i) target = map.update(hand_at(0.015), kTick_s);
  EXPECT_GT(target.tip_um.x, 1.0);
}

TEST(TeleoperationMap, SoftReturnPullsToTheCentreOfRateControlOnly) {
  TeleoperationMap rate(rate_settings());
  rate.engage(hand_at(0.01), {0.0, 0.0, 0.0});
  rate.update(hand_at(0.01), kTick_s);
  EXPECT_EQ(rate.centring_force_N(hand_at(0.011)).eigen().norm(), 0.0);
  EXPECT_NEAR(rate.centring_force_N(hand_at(0.022)).x, -20.0 * 0.010, 1e-9);
  EXPECT_NEAR(rate.centring_force_N(hand_at(0.3)).eigen().norm(), 0.5, 1e-9);
  EXPECT_EQ(TeleoperationMap().centring_force_N(hand_at(0.3)).eigen().norm(), 0.0);
}

TEST(TeleoperationMap, ClutchMovesTheCentre) {
  TeleoperationMap map;
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  map.update(hand_at(0.0), kTick_s);
  map.update(hand_at(0.04, 0.0, 0.0, kClutch), kTick_s);
  map.update(hand_at(0.05, 0.01, 0.0), kTick_s);
  EXPECT_NEAR(map.centre_m().x, 0.05, 1e-12);
  EXPECT_NEAR(map.centre_m().y, 0.01, 1e-12);
}

TEST(TeleoperationMap, KeepsTheTargetInTheBoxAndLetsItBackIn) {
  TeleoperationSettings settings;
  settings.box = {{-50.0, -50.0, -50.0}, {50.0, 50.0, 50.0}};
  TeleoperationMap map(settings, no_filter());
  map.engage(hand_at(0.0), {0.0, 0.0, 0.0});
  map.update(hand_at(0.0), kTick_s);
  TipTarget target = map.update(hand_at(0.1, 0.001), kTick_s);
  EXPECT_EQ(target.tip_um.x, 50.0);
  EXPECT_EQ(target.velocity_um_per_s.x, 0.0);
  EXPECT_NEAR(target.tip_um.y, -2.0, 1e-9);

  // Engaged outside, it does not leap to the edge; it can only come nearer.
  map.engage(hand_at(0.0), {80.0, 0.0, 0.0});
  map.update(hand_at(0.0), kTick_s);
  target = map.update(hand_at(0.001), kTick_s);
  EXPECT_EQ(target.tip_um.x, 80.0);
  target = map.update(hand_at(-0.005), kTick_s);
  EXPECT_NEAR(target.tip_um.x, 70.0, 1e-9);
  target = map.update(hand_at(0.0), kTick_s);
  EXPECT_NEAR(target.tip_um.x, 70.0, 1e-9);
}

TEST(TeleoperationMap, HoldsTheTipWhenTheHandIsNotANumber) {
  TeleoperationMap map({}, no_filter());
  map.engage(hand_at(0.0), {3.0, 0.0, 0.0});
  map.update(hand_at(0.0), kTick_s);
  const TipTarget target = map.update(hand_at(std::numeric_limits<double>::quiet_NaN()), kTick_s);
  EXPECT_EQ(target.tip_um.x, 3.0);
  EXPECT_NEAR(map.update(hand_at(0.001), kTick_s).tip_um.x, 5.0, 1e-9);
}

TEST(TeleoperationMap, RefusesSettingsThatMeanNothing) {
  TeleoperationSettings settings;
  settings.scale_um_per_m = 0.0;
  EXPECT_THROW(TeleoperationMap map(settings), UsageError);
  settings = {};
  settings.dead_zone_m = -1.0;
  EXPECT_THROW(TeleoperationMap().request(settings), UsageError);
  settings = {};
  settings.box.lower_um.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(TeleoperationMap().request(settings), UsageError);
}

}  // namespace
}  // namespace pellucida
