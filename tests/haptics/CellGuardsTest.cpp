#include "pellucida/haptics/CellGuards.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pellucida/haptics/HandMotion.h"

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;

// Pushes along +x towards `wanted`, with a cell of 0.2 uN/um touched at x = 0; the pipette follows at once.
class Push {
 public:
  explicit Push(const CellLimits& limits) : guards_(limits) { guards_.place(Vector::Zero()); }

  GuardOutput tick(const Vector& wanted_um) {
    GuardInput input;
    input.wanted_um = wanted_um;
    input.push = Vector(1.0, 0.0, 0.0);
    input.depth_um = std::max(0.0, guards_.tip_um().x());
    input.in_contact = input.depth_um > 0.0;
    input.contact_force_uN = 0.2 * input.depth_um;
    input.pipette.known = true;
    input.pipette.tip_um = follows ? guards_.tip_um() : Vector::Zero();
    return guards_.follow(input);
  }
  GuardOutput run(const Vector& wanted_um, int ticks) {
    GuardOutput output;
    for (int k = 0; k < ticks; ++k) output = tick(wanted_um);
    return output;
  }
  CellGuards& guards() { return guards_; }
  bool follows = true;

 private:
  CellGuards guards_;
};

TEST(CellGuards, WithoutLimitsTheProxyIsTheHand) {
  Push push({});
  const GuardOutput output = push.tick(Vector(-1.5, 0.5, 0.2));
  EXPECT_EQ(output.tip_um, Vector(-1.5, 0.5, 0.2));
  EXPECT_EQ(output.mode, GuardMode::kFollow);
  EXPECT_EQ(output.limits, 0U);
}

TEST(CellGuards, SpeedIsLimitedWhateverTheHandDoes) {
  CellLimits limits;
  limits.max_speed_um_per_s = 1000.0;
  Push push(limits);
  const GuardOutput output = push.tick(Vector(-500.0, 300.0, 0.0));
  EXPECT_NEAR(output.tip_um.norm(), 1.0, 1e-12);
  EXPECT_TRUE(output.limits & limit_bit(LimitKind::kSpeed));
}

TEST(CellGuards, TowardsTheLargestForceItSlowsAndHolds) {
  CellLimits limits;
  limits.max_force_uN = 4.0;
  Push push(limits);
  double last_um = 0.0;
  bool slowed = false;
  for (int k = 0; k < 5000; ++k) {
    const GuardOutput output = push.tick(Vector(100.0, 0.0, 0.0));
    EXPECT_GE(output.tip_um.x(), last_um);
    last_um = output.tip_um.x();
    slowed = slowed || output.mode == GuardMode::kSlow;
  }
  EXPECT_TRUE(slowed);
  EXPECT_LE(0.2 * last_um, 4.0 + 1e-9);
  EXPECT_GT(0.2 * last_um, 3.9999);
  // Drawing back is free at once.
  EXPECT_NEAR(push.tick(Vector(last_um - 1.0, 0.0, 0.0)).tip_um.x(), last_um - 1.0, 1e-9);
}

TEST(CellGuards, FarBeyondTheForceItTakesThePipetteBack) {
  CellLimits limits;
  limits.max_force_uN = 4.0;
  Push push(limits);
  push.guards().place(Vector(30.0, 0.0, 0.0));  // 6 uN: the limit was lowered, or the cell moved
  const GuardOutput first = push.tick(Vector(40.0, 0.0, 0.0));
  EXPECT_EQ(first.mode, GuardMode::kRetract);
  EXPECT_NEAR(first.velocity_um_per_s.x(), -limits.retract_speed_um_per_s, 1e-9);
  const GuardOutput later = push.run(Vector(40.0, 0.0, 0.0), 2000);
  EXPECT_LE(0.2 * later.tip_um.x(), 4.0);
  EXPECT_NE(later.mode, GuardMode::kRetract);
}

TEST(CellGuards, TheDepthIsLimitedTheSameWay) {
  CellLimits limits;
  limits.max_depth_um = 15.0;
  Push push(limits);
  const GuardOutput held = push.run(Vector(50.0, 0.0, 0.0), 5000);
  EXPECT_LE(held.tip_um.x(), 15.0 + 1e-9);
  EXPECT_GT(held.tip_um.x(), 14.999);
  EXPECT_TRUE(held.limits & limit_bit(LimitKind::kDepth));
  push.guards().place(Vector(21.0, 0.0, 0.0));
  EXPECT_EQ(push.tick(Vector(50.0, 0.0, 0.0)).mode, GuardMode::kRetract);
}

TEST(CellGuards, TheBoxIsNotLeftAndAShrunkenBoxIsNotAJump) {
  CellLimits limits;
  limits.upper_um.y = 5.0;
  Push push(limits);
  const GuardOutput output = push.run(Vector(-1.0, 50.0, 0.0), 1000);
  EXPECT_NEAR(output.tip_um.y(), 5.0, 1e-9);
  EXPECT_TRUE(output.limits & limit_bit(LimitKind::kTravel));
  limits.upper_um.y = -20.0;
  push.guards().set(limits);
  EXPECT_NEAR(push.tick(Vector(-1.0, 50.0, 0.0)).tip_um.y(), 5.0 - 1e-3 * limits.max_speed_um_per_s, 1e-9);
}

TEST(CellGuards, AManipulatorThatStaysBehindIsWaitedFor) {
  CellLimits limits;
  limits.max_lag_um = 20.0;
  Push push(limits);
  push.follows = false;
  const GuardOutput output = push.run(Vector(-500.0, 0.0, 0.0), 3000);
  EXPECT_LE(std::abs(output.tip_um.x()), 40.0 + 1e-9);
  EXPECT_TRUE(output.limits & limit_bit(LimitKind::kFollowing));
}

TEST(PipetteGuard, TellsUnknownAndJumps) {
  PipetteGuard guard;
  PipetteState state;
  EXPECT_EQ(guard.check(state, 1000.0), PipetteGuard::Report::kUnknown);
  state.known = true;
  EXPECT_EQ(guard.check(state, 1000.0), PipetteGuard::Report::kGood);
  state.time_s = 0.01;
  state.tip_um.x = 9.0;
  EXPECT_EQ(guard.check(state, 1000.0), PipetteGuard::Report::kGood);
  state.time_s = 0.02;
  state.tip_um.x = 100.0;
  EXPECT_EQ(guard.check(state, 1000.0), PipetteGuard::Report::kJump);
  state.tip_um.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(guard.check(state, 1000.0), PipetteGuard::Report::kUnknown);
}

TEST(HandGuard, LetsThroughWhatAHandCanDo) {
  HandGuard guard;
  HandSample sample;
  EXPECT_EQ(guard.check(sample, 0.0, 5.0), HandReading::kGood);
  sample.position_m.x = 0.005;
  EXPECT_EQ(guard.check(sample, 1e-3, 5.0), HandReading::kGood);
  sample.position_m.x = 0.05;
  EXPECT_EQ(guard.check(sample, 1e-3, 5.0), HandReading::kJump);
  EXPECT_EQ(guard.check(sample, 1e-3, 5.0), HandReading::kGood) << "the new place counts";
  sample.position_m.y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(guard.check(sample, 1e-3, 5.0), HandReading::kNotFinite);
  // After a pause a hand may have gone farther.
  sample.position_m = Vector(0.15, 0.0, 0.0);
  EXPECT_EQ(guard.check(sample, 0.1, 5.0), HandReading::kGood);
}

TEST(HandVelocity, FollowsARampAtOnceAndStandsStillBetweenSteps) {
  constexpr double kResolution_m = 2e-5;
  HandVelocity estimator(kResolution_m);
  const auto encoder = [&](double x) { return Vector(kResolution_m * std::round(x / kResolution_m), 0.0, 0.0); };
  double worst = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const double speed = estimator.update(1e-3 * k, encoder(0.05 * 1e-3 * k)).x();
    if (k > 20) worst = std::max(worst, std::abs(speed - 0.05));
  }
  // A plain difference is wrong by a step a tick: 0.02 m/s.
  EXPECT_LT(worst, 0.004);
  // At rest, flickering by one step, nearly no speed.
  double noise = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double speed = estimator.update(0.5 + 1e-3 * k, Vector(0.02 + (k % 2) * kResolution_m, 0.0, 0.0)).x();
    if (k > 20) noise = std::max(noise, std::abs(speed));
  }
  EXPECT_LT(noise, 0.002);
}

TEST(HandVelocity, AReadingThatIsNotLaterChangesNothing) {
  HandVelocity estimator(0.0);
  estimator.update(0.0, Vector::Zero());
  const Vector speed = estimator.update(1e-3, Vector(1e-3, 0.0, 0.0));
  EXPECT_EQ(estimator.update(1e-3, Vector(5.0, 0.0, 0.0)), speed);
}

}  // namespace
}  // namespace pellucida
