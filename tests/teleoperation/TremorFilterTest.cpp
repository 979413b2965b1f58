#include "pellucida/teleoperation/TremorFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <utility>

namespace pellucida {
namespace {

constexpr double kFilterTick_s = 0.001;

/// The share of a sine of `frequency_Hz` and `amplitude_m` that is left, after the filter has settled.
double share_left(const TremorOptions& options, double frequency_Hz, double amplitude_m) {
  TremorFilter filter(options);
  filter.reset(Eigen::Vector3d::Zero());
  double largest_m = 0.0;
  for (int tick = 1; tick <= 6000; ++tick) {
    const double value_m = amplitude_m * std::sin(2.0 * std::numbers::pi * frequency_Hz * tick * kFilterTick_s);
    filter.update({0.0, value_m, 0.0}, kFilterTick_s);
    if (tick > 3000) largest_m = std::max(largest_m, std::abs(filter.position_m().y()));
  }
  return largest_m / amplitude_m;
}

TEST(TremorFilter, TakesTheTremorBandDownAndLeavesSlowMotion) {
  // 100 um at the hand, the middle of what is published for physiological tremor.
  for (const auto& [frequency_Hz, limit] : {std::pair{8.0, 0.20}, std::pair{10.0, 0.12}, std::pair{12.0, 0.09}}) {
    const double left = share_left({}, frequency_Hz, 1e-4);
    std::cout << frequency_Hz << " Hz: " << left << " left\n";
    EXPECT_LT(left, limit) << frequency_Hz << " Hz";
  }
  EXPECT_NEAR(share_left({}, 0.5, 1e-3), 1.0, 0.0016);
}

TEST(TremorFilter, IsTheButterworthLowPassItClaimsToBe) {
  TremorOptions plain;
  plain.cutoff_rise_Hz_s_per_m = 0.0;
  for (const double frequency_Hz : {1.0, 3.0, 8.0, 12.0}) {
    const double expected = 1.0 / std::sqrt(1.0 + std::pow(frequency_Hz / plain.rest_cutoff_Hz, 4));
    EXPECT_NEAR(share_left(plain, frequency_Hz, 1e-4), expected, 1.2e-4) << frequency_Hz << " Hz";
  }
}

TEST(TremorFilter, LagsASlowRampByWhatItTells) {
  TremorOptions plain;
  plain.cutoff_rise_Hz_s_per_m = 0.0;
  TremorFilter filter(plain);
  filter.reset(Eigen::Vector3d::Zero());
  const double speed_m_per_s = 0.01;
  double hand_m = 0.0;
  for (int tick = 1; tick <= 2000; ++tick) {
    hand_m = speed_m_per_s * tick * kFilterTick_s;
    filter.update({hand_m, 0.0, 0.0}, kFilterTick_s);
  }
  EXPECT_NEAR((hand_m - filter.position_m().x()) / speed_m_per_s, filter.lag_s(), 5e-6);
  EXPECT_NEAR(filter.velocity_m_per_s().x(), speed_m_per_s, 1e-9);
}

TEST(TremorFilter, LagsFastMotionLess) {
  TremorFilter filter;
  filter.reset(Eigen::Vector3d::Zero());
  const double at_rest_s = filter.lag_s();
  for (int tick = 1; tick <= 3000; ++tick) filter.update({0.05 * tick * kFilterTick_s, 0.0, 0.0}, kFilterTick_s);
  std::cout << "lag " << at_rest_s << " s at rest, " << filter.lag_s() << " s at 50 mm/s\n";
  EXPECT_LT(filter.lag_s(), 0.4 * at_rest_s);
}

TEST(TremorFilter, IgnoresWhatIsNotANumberAndTimeThatStands) {
  TremorFilter filter;
  filter.reset({1.0, 2.0, 3.0});
  filter.update({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, kFilterTick_s);
  filter.update({5.0, 5.0, 5.0}, 0.0);
  EXPECT_EQ(filter.position_m(), Eigen::Vector3d(1.0, 2.0, 3.0));
  for (int tick = 0; tick < 3000; ++tick) filter.update({1.5, 2.0, 3.0}, kFilterTick_s);
  EXPECT_NEAR(filter.position_m().x(), 1.5, 1e-6);
}

TEST(TremorFilter, StaysStableWhenTicksAreVeryLate) {
  TremorFilter filter;
  filter.reset(Eigen::Vector3d::Zero());
  for (int tick = 0; tick < 200; ++tick) {
    filter.update({0.1, 0.0, 0.0}, tick % 3 == 0 ? 0.5 : 0.001);
    ASSERT_LT(filter.position_m().norm(), 0.2) << tick;
  }
}

}  // namespace
}  // namespace pellucida
