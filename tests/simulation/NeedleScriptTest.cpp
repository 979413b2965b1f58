#include "pellucida/simulation/NeedleScript.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pellucida {
namespace {

TEST(NeedleScript, GoesFromGapToDepthAndBack) {
  Scenario::Motion motion;
  motion.gap_um = 10;
  motion.indentation_um = 30;
  motion.hold_s = 1.0;
  motion.smoothing_s = 0.4;
  motion.retraction_speed_um_per_s = 20;
  const NeedleScript script(motion);
  EXPECT_NEAR(script.depth_um(0), -10, 1e-9);
  EXPECT_NEAR(script.depth_um(script.duration_s()), -10, 1e-9);
  EXPECT_NEAR(script.depth_um(script.duration_s() + 100), -10, 1e-9);

  // The depth is reached, not passed, and no speed beats the fastest one asked for.
  double largest = -1e9, fastest = 0;
  for (double t = 0; t < script.duration_s(); t += 1e-3) {
    largest = std::max(largest, script.depth_um(t));
    fastest = std::max(fastest, std::abs(script.depth_um(t + 1e-3) - script.depth_um(t)) / 1e-3);
  }
  EXPECT_NEAR(largest, 30, 1e-9);
  EXPECT_LE(fastest, motion.approach_speed_um_per_s + 1e-6);
}

TEST(NeedleScript, SpeedChangesSoftly) {
  Scenario::Motion motion;
  motion.smoothing_s = 0.3;
  const NeedleScript script(motion);
  // The largest change of speed is (largest speed) / smoothing.
  const double h = 1e-3;
  for (double t = h; t < script.duration_s() + 1; t += h) {
    const double bend = (script.depth_um(t + h) - 2 * script.depth_um(t) + script.depth_um(t - h)) / (h * h);
    ASSERT_LE(std::abs(bend), motion.approach_speed_um_per_s / motion.smoothing_s * 1.01) << t;
  }
}

TEST(NeedleScript, WithoutSmoothingSpeedsAreConstant) {
  Scenario::Motion motion;
  motion.gap_um = 0;
  motion.indentation_um = 20;
  motion.indentation_speed_um_per_s = 10;
  motion.smoothing_s = 0;
  motion.hold_s = 0;
  const NeedleScript script(motion);
  EXPECT_NEAR(script.duration_s(), 2.0, 1e-12);
  EXPECT_NEAR(script.depth_um(0.5), 5.0, 2e-8);
  EXPECT_NEAR(script.depth_um(1.5), 15.0, 2e-8);
  EXPECT_NEAR(script.depth_um(9), 20.0, 2e-8);
}

TEST(NeedleScript, NothingToDoStaysPut) {
  Scenario::Motion motion;
  motion.gap_um = 0;
  motion.indentation_um = 0;
  motion.hold_s = 0;
  motion.smoothing_s = 0;
  const NeedleScript script(motion);
  EXPECT_EQ(script.duration_s(), 0.0);
  EXPECT_NEAR(script.depth_um(0), 0, 1e-12);
  EXPECT_NEAR(script.depth_um(5), 0, 1e-12);
}

}  // namespace
}  // namespace pellucida
