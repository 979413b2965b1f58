#include "LiveClock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace pellucida {
namespace {

// A camera whose clock runs 150 ppm slow against the run's; messages take 5 ms and some.
void run_for(LiveClock& clock, double duration_s) {
  std::mt19937 random(4);
  std::exponential_distribution<double> late_s(1.0 / 0.002);
  for (double source_s = 0.0; source_s < duration_s; source_s += 0.02) {
    clock.add(source_s, 7.0 + (1.0 + 150e-6) * source_s + 0.005 + late_s(random));
  }
}

TEST(LiveClock, FollowsACameraThatDrifts) {
  LiveClock clock(true);
  run_for(clock, 1200.0);
  // The hand's ticks are put where the camera's clock is now; the least delay of all would be 0.18 s off by now.
  EXPECT_NEAR(clock.lag_s(), 7.005 + 150e-6 * 1200.0, 0.001);
  const auto json = nlohmann::json::parse(clock.json());
  EXPECT_NEAR(json["source_to_run"]["drift_ppm"].get<double>(), 150.0, 1.0);
  EXPECT_NEAR(json["source_to_run"]["offset_s"].get<double>(), 7.005, 0.001);
  EXPECT_GE(json["pairs_source_s_run_s"].size(), 100U);
  EXPECT_NEAR(clock.offsets(1300.0).at("run"), clock.lag_s(), 1e-9);
}

TEST(LiveClock, BeginsAnewWithItsSource) {
  LiveClock clock(true);
  run_for(clock, 20.0);
  clock.begin_anew();
  EXPECT_TRUE(std::isinf(clock.lag_s()));
  EXPECT_TRUE(clock.json().empty());
  EXPECT_TRUE(clock.offsets(1.0).empty());
  clock.add(0.0, 42.0);
  EXPECT_DOUBLE_EQ(clock.lag_s(), 42.0);
}

// A recording has no clock of its own: the run delivers it.
TEST(LiveClock, OfARecordingKeepsTheLeastDelay) {
  LiveClock clock(false);
  clock.add(0.0, 1.0);
  clock.add(1.0, 1.5);
  clock.add(2.0, 4.0);
  EXPECT_DOUBLE_EQ(clock.lag_s(), 0.5);
  EXPECT_TRUE(clock.json().empty());
}

}  // namespace
}  // namespace pellucida
