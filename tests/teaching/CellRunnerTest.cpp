// The poked cell on a thread of its own.
#include "pellucida/teaching/CellRunner.h"

#include <gtest/gtest.h>

#include "pellucida/core/Error.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

using test::wait_until;

TeachingParameters quick_parameters() {
  TeachingParameters p;
  p.mesh_frequency = 2;
  return p;
}

TEST(CellRunner, FollowsTheHand) {
  CellRunner runner(quick_parameters());
  runner.set_hand(15.0, 0.0);
  ASSERT_TRUE(wait_until([&] {
    const auto s = runner.newest();
    return s && s->depth_um > 5.0 && s->force_uN > 0.05;
  }));
  EXPECT_EQ(runner.newest()->hand_along_um, 15.0);
  EXPECT_FALSE(runner.newest()->node_forces);
  runner.explain(3);
  ASSERT_TRUE(wait_until([&] { return runner.newest()->node_forces.has_value(); }));
  EXPECT_EQ(runner.newest()->node_forces->node, 3);
  runner.rethrow();
}

TEST(CellRunner, ShowsABlowUpAndStartsAgain) {
  TeachingParameters p = quick_parameters();
  p.integrator = "symplectic-euler";
  p.time_step_us = 20000.0;
  CellRunner runner(p);
  runner.set_hand(5.0, 0.0);
  ASSERT_TRUE(wait_until([&] { return runner.newest() && runner.newest()->blow_up; }));
  EXPECT_TRUE(runner.newest()->blow_up->is_beyond_limit());
  const auto run = runner.newest()->run;
  runner.set_parameters(quick_parameters());
  ASSERT_TRUE(wait_until([&] { return runner.newest()->parameters.integrator == "implicit-euler"; }));
  EXPECT_TRUE(runner.newest()->blow_up);
  runner.restart();
  ASSERT_TRUE(wait_until([&] { return !runner.newest()->blow_up && runner.newest()->time_s > 0.05; }));
  EXPECT_EQ(runner.newest()->run, run + 1);
}

TEST(CellRunner, RefusesWrongParametersOnTheCallersThread) {
  CellRunner runner(quick_parameters());
  TeachingParameters p = quick_parameters();
  p.node_mass_kg = -1.0;
  EXPECT_THROW(runner.set_parameters(p), UsageError);
}

TEST(CellRunner, TheCurveHasEveryMomentOfARun) {
  TeachingParameters p = quick_parameters();
  p.time_step_us = 1000.0;
  CellRunner runner(p);
  runner.set_hand(15.0, 0.0);
  std::vector<CurvePoint> points;
  ASSERT_TRUE(wait_until([&] {
    for (const CurvePoint& point : runner.take_curve()) points.push_back(point);
    return !points.empty() && points.back().depth_um > 8.0;
  }));
  ASSERT_GT(points.size(), 20u);
  for (std::size_t k = 1; k < points.size(); ++k) {
    EXPECT_NEAR(points[k].time_s - points[k - 1].time_s, 2e-3, 1.001e-3);
    EXPECT_EQ(points[k].run, 0u);
  }
  EXPECT_GT(points.back().force_uN, 0.5);
  runner.restart();
  ASSERT_TRUE(wait_until([&] {
    const auto more = runner.take_curve();
    return !more.empty() && more.back().run == 1;
  }));
}

TEST(CellRunner, SlowMotionIsSlow) {
  TeachingParameters p = quick_parameters();
  p.pace_ratio = 0.01;
  p.time_step_us = 1000.0;
  CellRunner runner(p);
  ASSERT_TRUE(wait_until([&] { return runner.newest() && runner.newest()->pace_ratio > 0.0; }));
  EXPECT_LT(runner.newest()->pace_ratio, 0.02);
}

}  // namespace
}  // namespace pellucida
