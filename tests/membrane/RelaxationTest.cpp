// Force of a relaxing membrane, step by step, against closed forms.
#include "pellucida/membrane/Relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

const std::vector<RelaxationArm> kArms{{0.4, 1.2}, {0.27, 7.0}};
constexpr double kRamp_s = 1.0, kPeak_uN = 5.0;

double elastic_uN(double time_s) {
  return kPeak_uN * std::min(time_s, kRamp_s) / kRamp_s;
}

/// The convolution of a linear ramp and hold with G, worked out by hand.
double ramp_and_hold_uN(double time_s) {
  double force = elastic_uN(time_s);
  const double slope = kPeak_uN / kRamp_s;
  for (const RelaxationArm& arm : kArms) {
    const double until = std::min(time_s, kRamp_s);
    const double arm_force =
        slope * arm.time_s * (std::exp(-(time_s - until) / arm.time_s) - std::exp(-time_s / arm.time_s));
    force += arm.fraction * (arm_force - elastic_uN(time_s));
  }
  return force;
}

class FrameInterval : public ::testing::TestWithParam<double> {};

TEST_P(FrameInterval, RampAndHoldIsExactWhateverIt) {
  Relaxation relaxation(kArms);
  relaxation.start(0.0);
  for (int k = 1; k * GetParam() <= 20.0; ++k) {
    const double time_s = k * GetParam();
    EXPECT_NEAR(relaxation.advance(time_s, elastic_uN(time_s)), ramp_and_hold_uN(time_s), 1e-12) << time_s;
  }
}

// Intervals that meet the ramp's end, where the elastic force bends.
INSTANTIATE_TEST_SUITE_P(Seconds, FrameInterval, ::testing::Values(0.001, 1.0 / 32.0, 0.125, 0.5, 1.0));

TEST(Relaxation, AFrameThatIsMissingChangesNothingOnAStraightWay) {
  Relaxation all(kArms), some(kArms);
  all.start(0.0);
  some.start(0.0);
  for (int k = 1; k <= 30; ++k) {
    const double force = all.advance(k / 30.0, k * 0.1);
    if (k % 7 == 0 || k == 30) {
      EXPECT_NEAR(some.advance(k / 30.0, k * 0.1), force, 1e-12);
    }
  }
}

TEST(Relaxation, ASuddenPushFallsAsTheModulusDoes) {
  Relaxation relaxation(kArms);
  relaxation.start(3.0);
  EXPECT_DOUBLE_EQ(relaxation.advance(3.0, 2.0), 2.0);
  EXPECT_NEAR(relaxation.advance(5.5, 2.0), 2.0 * relaxation.modulus_ratio(2.5), 1e-12);
  EXPECT_NEAR(relaxation.advance(1e4, 2.0), 2.0 * 0.33, 1e-12);
  // A stamp that goes back moves no time; and the force can be released.
  EXPECT_NEAR(relaxation.advance(1.0, 2.0), 2.0 * 0.33, 1e-12);
  EXPECT_NEAR(relaxation.advance(1e4, 0.0), -2.0 * 0.67, 1e-12);
}

TEST(Relaxation, RampRatioIsThatOfARamp) {
  Relaxation relaxation(kArms);
  relaxation.start(0.0);
  EXPECT_NEAR(relaxation.advance(2.2, 4.0), 4.0 * relaxation.ramp_ratio(2.2), 1e-12);
  EXPECT_DOUBLE_EQ(relaxation.ramp_ratio(0.0), 1.0);
}

TEST(Relaxation, RateAndRestAreThoseOfItsFall) {
  Relaxation relaxation(kArms);
  relaxation.start(0.0);
  const double now_uN = relaxation.advance(1.0, 3.0), rate = relaxation.rate_uN_per_s();
  const double rest_uN = relaxation.relaxed_uN();
  EXPECT_NEAR((relaxation.advance(1.0 + 1e-6, 3.0) - now_uN) / 1e-6, rate, 6e-7);
  EXPECT_NEAR(relaxation.advance(1e4, 3.0), rest_uN, 1e-9);
}

TEST(Relaxation, StorageAndLossAreThoseOfASteadyVibration) {
  // Fe = sin(omega t): once settled, F = storage sin(omega t) + omega loss cos(omega t).
  constexpr double kOmega_per_s = 2.0, kStep_s = 1e-3;
  Relaxation relaxation(kArms);
  relaxation.start(0.0);
  double in_phase = 0.0, across = 0.0, length_s = 0.0;
  const double period_s = 2.0 * std::numbers::pi / kOmega_per_s;
  for (int k = 1; k * kStep_s < 40.0 * period_s; ++k) {
    const double t = k * kStep_s, force = relaxation.advance(t, std::sin(kOmega_per_s * t));
    if (t < 30.0 * period_s) continue;
    in_phase += force * std::sin(kOmega_per_s * t) * kStep_s;
    across += force * std::cos(kOmega_per_s * t) * kStep_s;
    length_s += kStep_s;
  }
  EXPECT_NEAR(2.0 * in_phase / length_s, relaxation.storage_ratio(kOmega_per_s), 5e-6);
  EXPECT_NEAR(2.0 * across / length_s, kOmega_per_s * relaxation.loss_s(kOmega_per_s), 7e-7);
}

TEST(Relaxation, WithoutArmsIsElastic) {
  Relaxation relaxation({});
  EXPECT_DOUBLE_EQ(relaxation.advance(0.1, 1.5), 1.5);
  EXPECT_DOUBLE_EQ(relaxation.advance(9.0, 0.5), 0.5);
}

TEST(Relaxation, ArmsThatCantBeAreRefused) {
  EXPECT_THROW(Relaxation({{0.5, 1.0}, {0.5, 2.0}}), UsageError);
  EXPECT_THROW(Relaxation({{-0.1, 1.0}}), UsageError);
  EXPECT_THROW(Relaxation({{0.1, 0.0}}), UsageError);
}

}  // namespace
}  // namespace pellucida
