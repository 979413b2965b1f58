// The force of a membrane that relaxes, frame by frame, in the estimate and as the hand gets it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"
#include "pellucida/mechanics/ContactModelBuilder.h"
#include "pellucida/mechanics/ForceObserver.h"
#include "pellucida/membrane/Relaxation.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

constexpr double kFramesPerS = 30.0, kDepth_um = 14.0;
constexpr int kRampFrames = 20;

CellProfile relaxing_profile(double elastic_ratio = 1.0) {
  CellProfile profile = testing::coarse_profile();
  profile.relaxation_arms = {{0.42, 1.2}, {0.27, 7.0}};
  profile.relaxation_elastic_ratio = elastic_ratio;
  return profile;
}

/// The needle opposite the holder, `frame` counted from contact; the depth rises for kRampFrames, then rests.
Observation frame_of(long frame, CellState state = CellState::kContact) {
  Observation o;
  o.time_s = static_cast<double>(frame) / kFramesPerS;
  o.frame_index = frame;
  o.state = state;
  o.confidence = 1.0;
  o.center_um = {200.0, 150.0};
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.outer.emplace();
  o.axis = {1.0, 0.0};
  const double depth_um =
      state == CellState::kContact ? kDepth_um * std::min(1.0, static_cast<double>(frame) / kRampFrames) : 0.0;
  o.needle = NeedlePose{o.center_um + (52.5 - depth_um) * o.axis, -o.axis, 5.0, 1.0, {}};
  HolderPose holder;
  holder.direction = {-1.0, 0.0};
  o.holder = holder;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.05;
  return o;
}

TEST(RelaxingForce, IsTheElasticForceThroughTheArms) {
  const CellProfile profile = relaxing_profile(1.25);
  CellProfile elastic_profile = profile;
  elastic_profile.relaxation_arms.clear();
  ForceObserver relaxing(profile), elastic(elastic_profile);
  Relaxation arms(profile.relaxation_arms);
  arms.start(0.0);
  relaxing.process(frame_of(0, CellState::kFree));
  elastic.process(frame_of(0, CellState::kFree));
  double peak_uN = 0.0, last_uN = 0.0;
  for (long frame = 1; frame <= 10 * 30; ++frame) {
    const ForceEstimate e = relaxing.process(frame_of(frame)), without = elastic.process(frame_of(frame));
    ASSERT_TRUE(e.converged);
    const double expected_uN = arms.advance(e.time_s, 1.25 * without.contact_force_uN);
    ASSERT_NEAR(e.contact_force_uN, expected_uN, 1e-9) << frame;
    EXPECT_NEAR(e.tip_force_uN.norm() / e.contact_force_uN, without.tip_force_uN.norm() / without.contact_force_uN,
                1e-6);
    EXPECT_NEAR(e.pressure_Pa * without.contact_force_uN, without.pressure_Pa * e.contact_force_uN, 1e-6);
    EXPECT_LE(e.contact_force_lower_uN, e.contact_force_uN);
    EXPECT_GE(e.contact_force_upper_uN, e.contact_force_uN);
    peak_uN = std::max(peak_uN, e.contact_force_uN);
    last_uN = e.contact_force_uN;
  }
  EXPECT_LT(last_uN, 0.6 * peak_uN);
}

TEST(RelaxingForce, ItsRateIsHowItFallsInTheHold) {
  ForceObserver observer(relaxing_profile());
  observer.process(frame_of(0, CellState::kFree));
  ForceEstimate before, now;
  for (long frame = 1; frame <= 60; ++frame) {
    before = now;
    now = observer.process(frame_of(frame));
  }
  EXPECT_LT(now.force_rate_uN_per_s, 0.0);
  EXPECT_NEAR((now.contact_force_uN - before.contact_force_uN) * kFramesPerS,
              0.5 * (now.force_rate_uN_per_s + before.force_rate_uN_per_s), 1e-4 * std::abs(now.force_rate_uN_per_s));
  EXPECT_GT(now.relaxed_force_uN, 0.0);
  EXPECT_LT(now.relaxed_force_uN, now.contact_force_uN);
  EXPECT_GT(now.errors.relaxation_uN, 0.0);
}

TEST(RelaxingForce, TheHandGetsSpringAndDamperOfTheArms) {
  CellProfile elastic_profile = relaxing_profile();
  elastic_profile.relaxation_arms.clear();
  ForceObserver elastic(elastic_profile), quick(relaxing_profile(), {.hand_frequency_Hz = 1.0}),
      slow(relaxing_profile(), {.hand_frequency_Hz = 1e-4});
  ForceEstimate e, q, s;
  for (long frame = 0; frame <= 25; ++frame) {
    const Observation o = frame_of(frame, frame == 0 ? CellState::kFree : CellState::kContact);
    e = elastic.process(o);
    q = quick.process(o);
    s = slow.process(o);
  }
  const double k = e.stiffness_uN_per_um;
  // At 1 Hz nearly all of the stiffness is left; a hand of hours feels the spring alone, and both arms' dampers.
  EXPECT_NEAR(q.stiffness_uN_per_um,
              k * (1.0 - 0.42 / (1.0 + std::pow(2.0 * std::numbers::pi * 1.2, 2)) -
                   0.27 / (1.0 + std::pow(2.0 * std::numbers::pi * 7.0, 2))),
              1e-9);
  EXPECT_NEAR(s.stiffness_uN_per_um, 0.31 * k, 1.1e-5 * k);
  EXPECT_NEAR(s.damping_uN_s_per_um - e.damping_uN_s_per_um, k * (0.42 * 1.2 + 0.27 * 7.0), 7e-5 * k);
  EXPECT_GT(q.damping_uN_s_per_um, e.damping_uN_s_per_um);

  const ContactModel model = contact_model(frame_of(25), q, 0.9);
  EXPECT_DOUBLE_EQ(model.stiffness_uN_per_um, q.stiffness_uN_per_um);
  EXPECT_DOUBLE_EQ(model.damping_uN_s_per_um, q.damping_uN_s_per_um);
  EXPECT_THROW(ForceObserver(relaxing_profile(), {.hand_frequency_Hz = 0.0}), UsageError);
}

TEST(RelaxingForce, ANewContactHasNoPast) {
  ForceObserver once(relaxing_profile()), twice(relaxing_profile());
  for (long frame = 0; frame <= 90; ++frame) {
    twice.process(frame_of(frame, frame == 0 ? CellState::kFree : CellState::kContact));
  }
  ForceEstimate a, b;
  for (long frame = 0; frame <= 15; ++frame) {
    const CellState state = frame == 0 ? CellState::kFree : CellState::kContact;
    Observation o = frame_of(frame, state);
    a = once.process(o);
    o.time_s += 100.0;
    b = twice.process(o);
  }
  EXPECT_NEAR(a.contact_force_uN, b.contact_force_uN, 1e-9 * a.contact_force_uN);
}

TEST(RelaxingForce, PullingBackNeverGivesAForceBelowNothing) {
  ForceObserver observer(relaxing_profile());
  for (long frame = 0; frame <= 300; ++frame) {
    observer.process(frame_of(frame, frame == 0 ? CellState::kFree : CellState::kContact));
  }
  for (long back = 19; back >= 1; --back) {
    Observation o = frame_of(back);
    o.time_s = (320.0 - static_cast<double>(back)) / kFramesPerS;
    const ForceEstimate e = observer.process(o);
    EXPECT_GE(e.contact_force_uN, 0.0);
    EXPECT_GE(e.contact_force_lower_uN, 0.0);
    EXPECT_TRUE(e.force_uN.allFinite());
  }
}

}  // namespace
}  // namespace pellucida
