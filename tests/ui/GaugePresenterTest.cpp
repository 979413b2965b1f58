#include "presenters/GaugePresenter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "presenters/PunctureMemory.h"

namespace pellucida {
namespace {

// A touch under a hand whose limits are unlike every default.
class Gauges : public testing::Test {
 protected:
  Gauges() {
    auto observation = std::make_shared<Observation>();
    observation->state = CellState::kContact;
    observation->indentation_sigma_um = 0.5;
    observation->needle = NeedlePose{.tip_um = {120.0, 50.0}, .direction = {-1.0, 0.0}, .tip_sigma_um = 0.4};
    scene_.observation = observation;
    Measurement& m = scene_.measurement;
    m.state = CellState::kContact;
    m.indentation_um = 20.0;
    m.contact_force_uN = 3.0;
    m.contact_force_lower_uN = 1.5;
    m.contact_force_upper_uN = 12.0;
    m.contact_force_picture_lower_uN = 2.5;
    m.contact_force_picture_upper_uN = 3.5;
    input_.scene = &scene_;
    input_.has_hand = true;
    input_.strength.puncture_force_uN = 4.0;
    input_.strength.puncture_depth_um = 30.0;
    input_.limits.max_force_uN = 6.0;
    input_.limits.max_depth_um = 40.0;
    input_.limits.max_speed_um_per_s = 300.0;
    input_.limits.max_contact_speed_um_per_s = 80.0;
    input_.speed_um_per_s = 20.0;
    plan_.entry_um = {140.0, 50.0, 0.0};
    plan_.target_um = {90.0, 50.0, 0.0};
    plan_.axis = {-1.0, 0.0, 0.0};
    plan_.depth_um = 50.0;
    plan_.options.approach_distance_um = 50.0;
  }

  Gauge force() const { return make_gauges(input_)[0]; }
  Gauge depth() const { return make_gauges(input_)[1]; }
  Gauge speed() const { return make_gauges(input_)[2]; }
  Gauge distance() const { return make_gauges(input_)[3]; }

  Scene scene_;
  InjectionPlan plan_;
  GaugeInput input_;
};

TEST_F(Gauges, TheForceStandsAgainstTheHandsLimit) {
  const Gauge gauge = force();
  EXPECT_EQ(gauge.value, "3.00 µN");
  EXPECT_EQ(gauge.limit, "limit 6.0 µN");
  EXPECT_NEAR(gauge.share, Gauge::kLimitShare * 0.5, 1e-12);
  EXPECT_NEAR(gauge.from, Gauge::kLimitShare * 0.25, 1e-12);
  EXPECT_EQ(gauge.to, 1.0);  // cut off at the bar's end
  EXPECT_NEAR(gauge.inner_to, Gauge::kLimitShare * 3.5 / 6.0, 1e-12);
  EXPECT_NEAR(gauge.usual_share, Gauge::kLimitShare * 4.0 / 6.0, 1e-12);
  EXPECT_EQ(gauge.level, GaugeLevel::kCalm);
  EXPECT_EQ(gauge.alarm, "");
}

TEST_F(Gauges, LimitsComeFromSettingsAndProfileAlone) {
  input_.limits.max_force_uN = 12.0;
  EXPECT_NEAR(force().share, Gauge::kLimitShare * 0.25, 1e-12);
  input_.has_hand = false;
  EXPECT_EQ(force().limit, "puncture 4.0 µN");
  EXPECT_NEAR(force().share, Gauge::kLimitShare * 0.75, 1e-12);
  EXPECT_EQ(depth().limit, "puncture 30 µm");
  EXPECT_EQ(speed().limit, "no hand, no limit");
  EXPECT_TRUE(std::isnan(speed().share));
}

TEST_F(Gauges, AForceNearAndAtItsLimitIsLoud) {
  scene_.measurement.contact_force_uN = 5.0;
  EXPECT_EQ(force().level, GaugeLevel::kNear);
  EXPECT_EQ(force().alarm, "83 % OF LIMIT");
  scene_.measurement.contact_force_uN = 6.0;
  EXPECT_EQ(force().level, GaugeLevel::kOver);
  EXPECT_EQ(force().alarm, "AT THE LIMIT");
}

TEST_F(Gauges, WhatIsDoubtfulOldOrLostIsLoud) {
  scene_.remarks.warning = "slip";
  EXPECT_EQ(force().alarm, "IN DOUBT");
  EXPECT_EQ(force().value, "3.00 µN");
  input_.frame_age_s = input_.limits.blind_age_s + 0.15;
  for (const Gauge& gauge : {force(), depth()}) {
    EXPECT_EQ(gauge.level, GaugeLevel::kNone);
    EXPECT_EQ(gauge.alarm, "OLD: 0.4 s");
  }
  input_.is_still = true;  // a paused picture is no alarm
  EXPECT_EQ(depth().alarm, "");
  scene_.measurement.state = CellState::kLost;
  EXPECT_EQ(depth().alarm, "CELL LOST");
}

TEST_F(Gauges, NoForceSaysSo) {
  scene_.measurement.contact_force_uN = Measurement::kNotMeasured;
  scene_.remarks.reason = "the tip can't be seen";
  EXPECT_EQ(force().value, "\u2013");
  EXPECT_EQ(force().alarm, "NO FORCE");
  EXPECT_EQ(force().note, "no force, see below");
  EXPECT_TRUE(std::isnan(force().share));
}

TEST_F(Gauges, TheNearerOfLimitAndDepthStopCounts) {
  EXPECT_EQ(depth().limit, "limit 40 µm");
  EXPECT_NEAR(depth().from, Gauge::kLimitShare * (20.0 - 1.96 * 0.5) / 40.0, 1e-12);
  input_.plan = &plan_;
  input_.depth_stop_um = 25.0;
  EXPECT_EQ(depth().limit, "depth stop 25 µm");
  EXPECT_NEAR(depth().share, Gauge::kLimitShare * 0.8, 1e-12);
  // The push slows `soft_depth_um` before it.
  scene_.measurement.indentation_um = 21.0;
  EXPECT_EQ(depth().level, GaugeLevel::kNear);
}

TEST_F(Gauges, InsideTheDepthIsTheTipsBeyondTheEntry) {
  scene_.measurement.state = CellState::kPunctured;
  scene_.measurement.indentation_um = 2.0;
  input_.plan = &plan_;
  input_.depth_stop_um = 60.0;
  EXPECT_EQ(depth().value, "20.0 µm");
  EXPECT_EQ(depth().note, "tip beyond the entry");
  EXPECT_EQ(depth().limit, "depth stop 60 µm");
}

TEST_F(Gauges, TheSpeedHasAnotherLimitInContact) {
  EXPECT_EQ(speed().limit, "limit 80 µm/s");
  EXPECT_EQ(speed().note, "forwards");
  scene_.measurement.state = CellState::kFree;
  input_.speed_um_per_s = -30.0;
  EXPECT_EQ(speed().limit, "limit 300 µm/s");
  EXPECT_EQ(speed().value, "30 µm/s");
  EXPECT_EQ(speed().note, "backwards");
  input_.speed_um_per_s.reset();
  EXPECT_EQ(speed().value, "\u2013");
}

TEST_F(Gauges, TheDistanceFillsTowardsTheTarget) {
  EXPECT_EQ(distance().note, "no plan yet");
  EXPECT_EQ(distance().level, GaugeLevel::kCalm);
  input_.plan = &plan_;
  input_.depth_stop_um = 60.0;
  EXPECT_EQ(distance().value, "30.0 µm");
  EXPECT_NEAR(distance().share, Gauge::kLimitShare * 0.7, 1e-12);
  EXPECT_GT(distance().usual_share, distance().limit_share);
  EXPECT_EQ(distance().note, "±0.8 µm");

  // What is seen without a cell may be another tool.
  scene_.measurement.state = CellState::kNoCell;
  EXPECT_EQ(distance().alarm, "NEEDLE NOT SEEN");
  scene_.measurement.state = CellState::kContact;

  // Unseen, it is where the manipulator says.
  auto unseen = std::make_shared<Observation>(*scene_.observation);
  unseen->needle.reset();
  scene_.observation = unseen;
  EXPECT_EQ(distance().alarm, "NEEDLE NOT SEEN");
  input_.tip_um = Eigen::Vector3d(85.0, 50.0, 0.0);
  EXPECT_EQ(distance().value, "5.0 µm");
  EXPECT_EQ(distance().note, "by the manipulator");
  input_.tip_um = Eigen::Vector3d(75.0, 50.0, 0.0);
  EXPECT_EQ(distance().alarm, "PAST THE DEPTH STOP");
}

TEST_F(Gauges, BeforeTheFirstSceneNothingIsLoud) {
  input_ = GaugeInput{};
  for (const Gauge& gauge : make_gauges(input_)) {
    EXPECT_EQ(gauge.level, GaugeLevel::kCalm) << gauge.name;
    EXPECT_TRUE(std::isnan(gauge.share)) << gauge.name;
  }
}

TEST(TipSpeed, FollowsATipThatIsSeen) {
  TipSpeed meter;
  std::optional<double> speed;
  for (int frame = 0; frame < 60; ++frame) {
    Scene scene;
    auto observation = std::make_shared<Observation>();
    observation->needle = NeedlePose{.tip_um = {100.0 - 2.0 * frame, 0.0}, .direction = {-1.0, 0.0}};
    scene.observation = observation;
    scene.measurement.time_s = 0.05 * frame;
    speed = meter.update(scene);
  }
  ASSERT_TRUE(speed);
  EXPECT_NEAR(*speed, 40.0, 1e-6);
  EXPECT_FALSE(meter.update(Scene{}));
}

// A manipulator that advances 2 um four times a second: 8 um/s, at whatever moment one looks, also in a tremor's way
// back.
TEST(TipSpeed, OfStepsIsTheirMean) {
  TipSpeed meter;
  double lowest = 1e9, highest = -1e9;
  for (int tick = 0; tick <= 200; ++tick) {
    const double time_s = 0.02 * tick, step_um = 2.0 * std::floor(time_s / 0.25),
                 tremor_um = 0.2 * std::sin(60.0 * time_s);
    const auto velocity_um_per_s = meter.update(time_s, {100.0 - step_um - tremor_um, 5.0, -3.0});
    if (time_s < 1.0) continue;
    ASSERT_TRUE(velocity_um_per_s);
    EXPECT_NEAR(velocity_um_per_s->tail<2>().norm(), 0.0, 1e-9);
    lowest = std::min(lowest, -velocity_um_per_s->x());
    highest = std::max(highest, -velocity_um_per_s->x());
  }
  EXPECT_GT(lowest, 0.0);
  EXPECT_LT(highest, 25.0);
  meter.forget();
  EXPECT_FALSE(meter.update(9.0, {0.0, 0.0, 0.0}));
  // Drawn back: against the way into the cell.
  const std::optional<double> speed = meter.update(9.5, {1.5, 2.0, 0.0}, {-1.0, 0.0, 0.0});
  ASSERT_TRUE(speed);
  EXPECT_NEAR(*speed, -5.0, 1e-9);
}

TEST(TipSpeed, TheWayInwardsIsThePlansElseTheNeedles) {
  Scene scene;
  auto observation = std::make_shared<Observation>();
  observation->needle = NeedlePose{.direction = {-0.6, 0.8}};
  scene.observation = observation;
  InjectionPlan plan;
  plan.axis = {0.0, 0.0, 1.0};
  EXPECT_EQ(way_inwards(&plan, &scene), Eigen::Vector3d(0.0, 0.0, 1.0));
  EXPECT_EQ(way_inwards(nullptr, &scene), Eigen::Vector3d(-0.6, 0.8, 0.0));
  EXPECT_TRUE(way_inwards(nullptr, nullptr).isZero());
}

TEST(PunctureMemory, StaysUntilTheNextCell) {
  PunctureMemory memory;
  const Event puncture{3.0, event_kind::kPuncture, "at 7.27 uN and 43.6 um, work 62.4 uN um; membrane back at 3.1 um"};
  memory.take({{puncture, {4.0, event_kind::kRelease, ""}, {5.0, event_kind::kContact, ""}}});
  EXPECT_EQ(memory.text(), "7.27 µN · 43.6 µm · 62.4 pJ");
  memory.take({{{6.0, event_kind::kNote, "new cell"}}});
  EXPECT_EQ(memory.text(), "");
  // It was none.
  memory.take({{puncture, {6.5, event_kind::kRevoked, ""}}});
  EXPECT_EQ(memory.text(), "");
  // A real cell: another one was found, and is touched.
  memory.take({{puncture, {7.0, event_kind::kLost, ""}, {8.0, event_kind::kFound, ""}}});
  EXPECT_NE(memory.text(), "");
  memory.take({{{9.0, event_kind::kContact, ""}}});
  EXPECT_EQ(memory.text(), "");
}

}  // namespace
}  // namespace pellucida
