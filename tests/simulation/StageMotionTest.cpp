#include "pellucida/simulation/StageMotion.h"

#include <gtest/gtest.h>

#include <numbers>

#include "pellucida/simulation/VirtualMicroscope.h"
#include "simulation/TestScenes.h"

namespace pellucida {
namespace {

using test::scenario_of;

TEST(StageMotion, KnocksGoThereAndBack) {
  const Scenario s = scenario_of(R"({"drift": {"jump_x_px": 30, "jump_y_px": -10, "jump_period_s": 0.5}})");
  const Eigen::Vector2d knock(30 * 0.825, -10 * 0.825);
  for (const auto& [time_s, there] : {std::pair(0.0, false), std::pair(0.49, false), std::pair(0.5, true),
                                      std::pair(0.99, true), std::pair(1.0, false), std::pair(1.7, true)})
    EXPECT_NEAR((stage_pose(s, time_s).shift_um - (there ? knock : Eigen::Vector2d(0, 0))).norm(), 0.0, 1e-12)
        << time_s;
}

TEST(StageMotion, TurnsAboutTheImagesCentre) {
  const Scenario s = scenario_of(
      R"({"image": {"width_px": 101, "height_px": 201, "pixel_size_um": 2}, "drift": {"rotation_deg_per_s": 45}})");
  const StagePose pose = stage_pose(s, 2.0);
  EXPECT_NEAR(pose.rotation_rad, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR((pose.place(Eigen::Vector2d(100, 200)) - Eigen::Vector2d(100, 200)).norm(), 0.0, 1e-9);
  // +x goes to +y.
  EXPECT_NEAR((pose.place(Eigen::Vector2d(110, 200)) - Eigen::Vector2d(100, 210)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((pose.turn(Eigen::Vector2d(1, 0)) - Eigen::Vector2d(0, 1)).norm(), 0.0, 1e-12);
}

TEST(StageMotion, TruthTurnsAsOneBody) {
  const char* still = R"({"image": {"frame_rate_hz": 2}, "tools": {"configuration": 2}})";
  const char* turning =
      R"({"image": {"frame_rate_hz": 2}, "tools": {"configuration": 2}, "drift": {"rotation_deg_per_s": 20}})";
  VirtualMicroscope a(scenario_of(still)), b(scenario_of(turning));
  while (a.skip() && b.skip()) {
    const Observation &one = a.truth().observation, &two = b.truth().observation;
    EXPECT_NEAR(two.rotation_rad, 20 * std::numbers::pi / 180 * one.time_s, 1e-12);
    EXPECT_NEAR(two.indentation_um, one.indentation_um, 1e-12);
    EXPECT_NEAR(two.axis.dot(two.holder->direction), one.axis.dot(one.holder->direction), 1e-12);
    EXPECT_NEAR((two.needle->tip_um - two.center_um).norm(), (one.needle->tip_um - one.center_um).norm(), 1e-9);
    const StagePose pose = stage_pose(b.scenario(), two.time_s);
    for (Eigen::Index i = 0; i < one.outer->points_um.cols(); i += 37)
      EXPECT_NEAR((pose.place(Eigen::Vector2d(one.outer->points_um.col(i))) - two.outer->points_um.col(i)).norm(), 0.0,
                  1e-9);
  }
}

TEST(StageMotion, LampStepsAndFlickers) {
  Scenario::Lamp lamp;
  EXPECT_EQ(lamp_ratio(lamp, 5.0), 1.0);
  lamp.step_ratio = 0.6;
  EXPECT_EQ(lamp_ratio(lamp, 0.99), 1.0);
  EXPECT_EQ(lamp_ratio(lamp, 1.0), 0.6);
  lamp.flicker_ratio = 0.1;
  EXPECT_NEAR(lamp_ratio(lamp, 0.25), 1.1, 1e-12);
  EXPECT_NEAR(lamp_ratio(lamp, 1.75), 0.54, 1e-12);
}

}  // namespace
}  // namespace pellucida
