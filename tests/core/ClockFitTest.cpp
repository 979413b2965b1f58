#include "pellucida/core/ClockFit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pellucida {
namespace {

// A camera whose clock began `offset_s` before the run's and drifts; its messages arrive 4 ms late at least, usually
// little more, and sometimes much more.
struct CameraWithClock {
  double offset_s = 0.0;
  double drift_ppm = 0.0;
  double rate_hz = 30.0;
  double duration_s = 600.0;
};

constexpr double kLeastDelay_s = 0.004;

ClockPairs stamps_of(const CameraWithClock& device, unsigned seed) {
  std::mt19937 random(seed);
  std::exponential_distribution<double> delay_s(1.0 / 0.003);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  ClockPairs pairs;
  bool stalled = false;
  for (int i = 0; i < static_cast<int>(device.rate_hz * device.duration_s); ++i) {
    const double device_s = i / device.rate_hz;
    // The computer is busy for a while now and then.
    if (uniform(random) < 0.01) stalled = !stalled;
    const double late_s = kLeastDelay_s + delay_s(random) + (stalled ? 0.05 * uniform(random) : 0.0);
    pairs.add(device_s, device.offset_s + (1.0 + 1e-6 * device.drift_ppm) * device_s + late_s);
  }
  return pairs;
}

TEST(ClockFit, FindsOffsetAndDriftOfADevice) {
  int within_three_sigma = 0;
  int count = 0;
  for (const double drift_ppm : {-200.0, -15.0, 0.0, 40.0, 120.0}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      const CameraWithClock device{.offset_s = -12.5 + seed, .drift_ppm = drift_ppm};
      const auto fit = stamps_of(device, seed).fit();
      ASSERT_TRUE(fit);
      EXPECT_NEAR(fit->drift_ppm, drift_ppm, 3.0);
      // The least delay can't be told from an offset; beyond it, 2 ms at any time of the recording.
      for (const double device_s : {0.0, 300.0, 600.0}) {
        const double true_s = device.offset_s + (1.0 + 1e-6 * drift_ppm) * device_s + kLeastDelay_s;
        EXPECT_NEAR(fit->run_s(device_s), true_s, 0.002) << drift_ppm << " ppm, seed " << seed;
      }
      within_three_sigma += std::abs(fit->drift_ppm - drift_ppm) < 3.0 * fit->drift_sigma_ppm ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GE(within_three_sigma, count * 8 / 10);
}

TEST(ClockFit, OfAnyLengthInTheSameMemory) {
  const ClockPairs pairs = stamps_of({.offset_s = 1.0, .drift_ppm = 80.0, .rate_hz = 100.0, .duration_s = 7200.0}, 3);
  EXPECT_LE(pairs.pairs().size(), 256U);
  ASSERT_TRUE(pairs.fit());
  EXPECT_NEAR(pairs.fit()->drift_ppm, 80.0, 0.3);
}

TEST(ClockFit, SaysNothingOfAFewSeconds) {
  EXPECT_FALSE(stamps_of({.duration_s = 3.0}, 1).fit());
  EXPECT_FALSE(ClockPairs().fit());
}

TEST(ClockFit, PassesOverWhatIsNoStamp) {
  ClockPairs pairs = stamps_of({.offset_s = 2.0, .duration_s = 60.0}, 1);
  const std::size_t count = pairs.pairs().size();
  pairs.add(std::nan(""), 1.0);
  pairs.add(70.0, INFINITY);
  pairs.add(1.0, 3.0);
  EXPECT_EQ(pairs.pairs().size(), count);
}

}  // namespace
}  // namespace pellucida
