#include "pellucida/haptics/ContactPredictor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pellucida {
namespace {

using Vector = Eigen::Vector3d;
constexpr double kDt_s = 1e-3;

double cubic_uN(double depth_um) {
  return depth_um > 0.0 ? 7.5 * std::pow(depth_um / 44.0, 3) : 0.0;
}

// A needle that goes along +x into a cell touched at x = 0, seen by frames.
class Bench {
 public:
  explicit Bench(const PredictorSettings& settings = {}) : predictor_(settings) {}

  ContactModel frame(double depth_um) {
    ContactModel model;
    model.time_s = now_s;
    model.frame_index = ++frame_index_;
    model.valid = true;
    model.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
    model.push = Vector(1.0, 0.0, 0.0);
    model.force_uN = Vector(-cubic_uN(depth_um), 0.0, 0.0);
    model.stiffness_uN_per_um = depth_um > 0.0 ? 3.0 * cubic_uN(depth_um) / depth_um : 0.0;
    model.depth_um = std::max(0.0, depth_um);
    return model;
  }

  void see(const ContactModel& model) { predictor_.see(model, history_); }

  ContactForce tick(double x_um, double dt_s = kDt_s) {
    now_s += dt_s;
    const Vector velocity((x_um - x_um_) / dt_s, 0.0, 0.0);
    x_um_ = x_um;
    history_.add(now_s, Vector(x_um, 0.0, 0.0));
    return predictor_.update(now_s, dt_s, Vector(x_um, 0.0, 0.0), velocity);
  }

  // Stands at that depth with frames at 30 Hz until the force has settled.
  ContactForce settle(double x_um) {
    ContactForce force;
    for (int k = 0; k < 600; ++k) {
      if (k % 33 == 0) see(frame(x_um));
      force = tick(x_um);
    }
    return force;
  }

  double now_s = 0.0;

 private:
  ContactPredictor predictor_;
  TipHistory history_;
  double x_um_ = 0.0;
  long frame_index_ = 0;
};

TEST(ContactPredictor, StandingStillItIsTheFramesForce) {
  Bench bench;
  const ContactForce force = bench.settle(30.0);
  EXPECT_EQ(force.state, ContactState::kContact);
  EXPECT_NEAR(force.force_uN.x(), -cubic_uN(30.0), 1e-6);
  EXPECT_NEAR(force.depth_um, 30.0, 1e-9);
}

TEST(ContactPredictor, BetweenFramesItFollowsTheTipAlongTheCurve) {
  for (const double way_um : {-25.0, -10.0, -2.0, -0.1, 0.1, 1.0, 3.0}) {
    Bench bench;
    bench.settle(30.0);
    bench.see(bench.frame(30.0));
    ContactForce force;
    for (int k = 1; k <= 30; ++k) force = bench.tick(30.0 + way_um * k / 30.0);
    const double truth = cubic_uN(30.0 + way_um);
    EXPECT_NEAR(force.along_uN, truth, 1e-9) << way_um;
  }
}

// A push at constant speed up to the puncture's depth, frames at 30 Hz that arrive 20 ms late.
TEST(ContactPredictor, OnAPushItIsFarNearerThanTheLastFrameHeld) {
  for (const double speed_um_per_s : {20.0, 200.0}) {
    PredictorSettings settings;
    settings.tip_lag_s = 0.02;
    Bench bench(settings);
    bench.settle(5.0);
    ContactModel waiting = bench.frame(5.0), held = waiting;
    double due_s = -1.0, next_s = bench.now_s, depth_um = 5.0, worst_uN = 0.0, worst_held_uN = 0.0;
    while (depth_um < 44.0) {
      if (due_s >= 0.0 && bench.now_s >= due_s) {
        waiting.time_s = bench.now_s;
        bench.see(waiting);
        held = waiting;
        due_s = -1.0;
      }
      if (bench.now_s >= next_s) {
        waiting = bench.frame(depth_um);
        due_s = bench.now_s + 0.02;
        next_s += 1.0 / 30.0;
      }
      depth_um += 1e-3 * speed_um_per_s;
      const double felt_uN = bench.tick(depth_um).along_uN;
      if (depth_um < 30.0) continue;
      worst_uN = std::max(worst_uN, std::abs(felt_uN - cubic_uN(depth_um)));
      worst_held_uN = std::max(worst_held_uN, std::abs(-held.force_uN.x - cubic_uN(depth_um)));
    }
    std::printf("%5.0f um/s, 30 to 44 um deep: wrong by %.3f uN at most; the last frame held: %.3f uN\n",
                speed_um_per_s, worst_uN, worst_held_uN);
    EXPECT_LT(worst_uN, 0.1 * worst_held_uN);
  }
}

TEST(ContactPredictor, OutOfContactItNeverPushes) {
  Bench bench;
  bench.settle(20.0);
  bench.see(bench.frame(20.0));
  for (int k = 1; k <= 40; ++k) {
    const double x_um = 20.0 - k;
    const ContactForce force = bench.tick(x_um);
    EXPECT_LE(force.force_uN.x(), 0.0) << "never along the push";
    if (x_um <= 0.0) {
      EXPECT_EQ(force.along_uN, 0.0) << x_um;
    }
  }
}

TEST(ContactPredictor, AFrameNeverMakesAStep) {
  // The frame says a third more than was predicted.
  PredictorSettings settings;
  Bench bench(settings);
  double last = bench.settle(30.0).along_uN;
  ContactModel model = bench.frame(30.0);
  model.force_uN.x *= 4.0 / 3.0;
  bench.see(model);
  const double goal = -model.force_uN.x;
  for (int k = 0; k < 300; ++k) {
    if (k % 33 == 32) {
      ContactModel again = bench.frame(30.0);
      again.force_uN.x *= 4.0 / 3.0;
      bench.see(again);
    }
    const double force = bench.tick(30.0).along_uN;
    EXPECT_LE(std::abs(force - last), 1.001 * settings.correction_slope_uN_per_s * kDt_s + 1e-9) << k;
    EXPECT_LE(force, goal + 1e-9) << "no overshoot";
    last = force;
  }
  EXPECT_NEAR(last, goal, 7e-5);
}

TEST(ContactPredictor, AnOldFrameIsDampedToZeroAndReported) {
  PredictorSettings settings;
  Bench bench(settings);
  bench.settle(30.0);
  bench.see(bench.frame(30.0));
  double last = bench.tick(30.0).along_uN;
  ContactForce force;
  for (int k = 1; k <= 160; ++k) {
    force = bench.tick(30.0);
    if (force.age_s < settings.age_limit_s) {
      EXPECT_EQ(force.state, ContactState::kContact);
    } else if (force.age_s > settings.age_limit_s + kDt_s) {
      EXPECT_EQ(force.state, ContactState::kStale);
    }
    EXPECT_LE(force.along_uN, last + 1e-12);
    EXPECT_LE(last - force.along_uN, 1.01 * cubic_uN(30.0) * kDt_s / settings.stale_time_s + 1e-9);
    last = force.along_uN;
  }
  EXPECT_EQ(force.along_uN, 0.0);
  // With frames again it comes back, slowly.
  bench.see(bench.frame(30.0));
  EXPECT_LE(bench.tick(30.0).along_uN, 1.01 * cubic_uN(30.0) * kDt_s / settings.return_time_s);
}

TEST(ContactPredictor, NumbersThatAreNotFiniteDampToZero) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int what = 0; what < 5; ++what) {
    Bench bench;
    bench.settle(30.0);
    double last = bench.tick(30.0).along_uN;
    ContactForce force;
    for (int k = 0; k < 100; ++k) {
      ContactModel model = bench.frame(30.0);
      if (what == 0) model.force_uN.y = nan;
      if (what == 1) model.stiffness_uN_per_um = nan;
      if (what == 2) model.push = PlainVector3();
      if (what == 3) model.valid = false;
      if (what == 4) model.state = CellState::kLost;
      bench.see(model);
      force = bench.tick(30.0);
      EXPECT_EQ(force.state, ContactState::kInvalid);
      EXPECT_TRUE(force.force_uN.allFinite());
      EXPECT_LE(force.along_uN, last + 1e-12);
      last = force.along_uN;
    }
    EXPECT_EQ(force.along_uN, 0.0) << what;
  }
}

TEST(ContactPredictor, APunctureReportedInTheFrameReleasesInTime) {
  PredictorSettings settings;
  Bench bench(settings);
  const double before = bench.settle(40.0).along_uN;
  ContactModel model = bench.frame(40.0);
  model.state = CellState::kPunctured;
  bench.see(model);
  double last = before;
  int ticks = 0;
  bool reported = false;
  while (last > 0.0 && ticks < 100) {
    const ContactForce force = bench.tick(40.0);
    reported = reported || force.punctured_now;
    EXPECT_LE(force.along_uN, last) << "no kick";
    last = force.along_uN;
    ++ticks;
  }
  EXPECT_TRUE(reported);
  EXPECT_LE(kDt_s * ticks, settings.release_time_s + 1.5 * kDt_s);
}

TEST(ContactPredictor, ADropOfTheForceIsAPunctureAndDrawingBackIsNot) {
  Bench punctured;
  punctured.settle(40.0);
  ContactModel dropped = punctured.frame(40.0);
  dropped.force_uN.x *= 0.2;
  punctured.see(dropped);
  EXPECT_TRUE(punctured.tick(40.0).punctured_now);

  Bench drawn_back;
  drawn_back.settle(40.0);
  for (int k = 1; k <= 33; ++k) drawn_back.tick(40.0 - 0.6 * k);
  drawn_back.see(drawn_back.frame(40.0 - 0.6 * 33));
  EXPECT_FALSE(drawn_back.tick(40.0 - 0.6 * 33).punctured_now);
}

TEST(ContactPredictor, AfterAPunctureAndBeingFreeANewContactIsFelt) {
  Bench bench;
  bench.settle(40.0);
  ContactModel model = bench.frame(40.0);
  model.state = CellState::kPunctured;
  bench.see(model);
  for (int k = 0; k < 50; ++k) bench.tick(40.0);
  bench.see(bench.frame(-5.0));
  for (int k = 0; k < 5; ++k) bench.tick(-5.0);
  const ContactForce force = bench.settle(20.0);
  EXPECT_EQ(force.state, ContactState::kContact);
  EXPECT_NEAR(force.along_uN, cubic_uN(20.0), 1e-6);
}

TEST(ContactPredictor, TheStepFromFrameToFrameIsNotStifferThanAllowed) {
  PredictorSettings settings;
  settings.max_stiffness_uN_per_um = 0.1;
  Bench bench(settings);
  const double before = bench.settle(40.0).along_uN;
  bench.see(bench.frame(40.0));
  bench.tick(40.0);
  EXPECT_NEAR(bench.tick(45.0).along_uN - before, 0.5, 1e-9);
}

TEST(ContactPredictor, DampingResistsAndNeverTurnsTheForceRound) {
  Bench bench;
  bench.settle(30.0);
  ContactModel model = bench.frame(30.0);
  model.damping_uN_s_per_um = 0.01;
  bench.see(model);
  bench.tick(30.0);
  EXPECT_GT(bench.tick(30.0 + 0.05).along_uN, cubic_uN(30.05)) << "pushing on at 50 um/s";
  const ContactForce drawn = bench.tick(29.0);
  EXPECT_GE(drawn.along_uN, 0.0) << "drawing back at 1000 um/s";
}

}  // namespace
}  // namespace pellucida
