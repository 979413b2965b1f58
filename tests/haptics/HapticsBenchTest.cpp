#include "pellucida/haptics/HapticsBench.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

TEST(HapticsBench, RunsTheWholeLoopAndCountsIt) {
  HapticsBenchOptions options;
  options.seconds = 1.5;
  options.lock_memory = false;
  const HapticsFigures figures = measure_haptics(options);
  EXPECT_GT(figures.ticks, 10U);
  EXPECT_EQ(figures.lateness_us.count, figures.ticks);
  EXPECT_EQ(figures.compute_us.count, figures.ticks);
  EXPECT_GT(figures.contact_ticks, 0U) << "the cell was felt";
  EXPECT_EQ(figures.records_dropped, 0U);
  EXPECT_LE(figures.lateness_us.p50_us, figures.lateness_us.p99_99_us);
  EXPECT_LE(figures.lateness_us.p99_99_us, figures.lateness_us.max_us);
  EXPECT_GT(figures.compute_us.p50_us, 0.0);
  EXPECT_FALSE(figures.policy.empty());
}

TEST(HapticsBench, EndsEarlyWhenInterrupted) {
  HapticsBenchOptions options;
  options.seconds = 3600.0;
  options.lock_memory = false;
  options.interrupted = [] { return true; };
  EXPECT_LT(measure_haptics(options).ticks, 100000U);
}

TEST(HapticsBench, RefusesNonsense) {
  HapticsBenchOptions options;
  options.seconds = 0.0;
  EXPECT_THROW(measure_haptics(options), UsageError);
  options.seconds = 1.0;
  options.frames_per_s = -1.0;
  EXPECT_THROW(measure_haptics(options), UsageError);
  options.frames_per_s = 30.0;
  options.device = "Mouse";
  EXPECT_THROW(measure_haptics(options), UsageError);
}

}  // namespace
}  // namespace pellucida
