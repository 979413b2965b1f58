// The tracker over a grid of what microscopes and cells bring: angles, scales, light, depth of grey, lost frames,
// jumps.
#include <gtest/gtest.h>

#include <cmath>

#include "pellucida/core_vtk/SceneData.h"
#include "tracking/ScenarioRun.h"

namespace pellucida {
namespace {

void expect_followed(const Scenario& scenario, const std::vector<test::FrameError>& errors, double outer_px,
                     double tip_px) {
  const test::ErrorSummary outer = summarize(errors, &test::FrameError::outer_px);
  const test::ErrorSummary tip = summarize(errors, &test::FrameError::tip_px);
  EXPECT_EQ(outer.missing, 0) << scenario.name;
  EXPECT_LT(outer.rms, outer_px) << scenario.name;
  EXPECT_LE(tip.missing, static_cast<int>(errors.size()) / 10) << scenario.name;
  EXPECT_LT(tip.rms, tip_px) << scenario.name;
  for (std::size_t k = 0; k < errors.size(); ++k)
    if (errors[k].confidence > 0.8) {
      EXPECT_LT(errors[k].outer_px, 2.0) << scenario.name << " frame " << k;
    }
}

class HolderAngle : public testing::TestWithParam<int> {};

TEST_P(HolderAngle, NeedleFromAnySide) {
  Scenario scenario = load_scenario("default");
  scenario.name = "angle";
  scenario.tools.holder_angle_deg = GetParam();
  scenario.cell.center_x_um = 300.0;
  MembraneTracker tracker;
  expect_followed(scenario, test::run_scenario(scenario, tracker, 2), 0.4, 1.2);
}

INSTANTIATE_TEST_SUITE_P(AllRound, HolderAngle, testing::Values(0, 50, 90, 130, 200, 245, 270, 320));

class PixelSize : public testing::TestWithParam<double> {};

TEST_P(PixelSize, AnyMagnification) {
  Scenario scenario = load_scenario("default");
  scenario.name = "magnification";
  scenario.image.pixel_size_um = GetParam();
  // The cell stays in the picture's left half, the picture keeps its size in um as far as memory is kind.
  const double scale = 0.825 / GetParam();
  scenario.image.width_px = static_cast<int>(std::lround(500 * scale));
  scenario.image.height_px = static_cast<int>(std::lround(300 * scale));
  scenario.cell.center_x_um = 180.0;
  scenario.cell.center_y_um = 120.0;
  MembraneTracker tracker;
  expect_followed(scenario, test::run_scenario(scenario, tracker, 2), 0.8, 3.0);
}

INSTANTIATE_TEST_SUITE_P(Microscopes, PixelSize, testing::Values(0.3, 0.5, 1.2));

TEST(Robustness, SixteenBitsGiveTheSameCell) {
  Scenario scenario = load_scenario("default");
  scenario.name = "16 bit";
  scenario.image.bit_depth = 16;
  MembraneTracker tracker;
  expect_followed(scenario, test::run_scenario(scenario, tracker, 2), 0.4, 1.2);
}

TEST(Robustness, FourOfFiveFramesLost) {
  Scenario scenario = load_scenario("default");
  scenario.name = "dropped frames";
  MembraneTracker tracker;
  expect_followed(scenario, test::run_scenario(scenario, tracker, 5), 0.4, 1.2);
}

TEST(Robustness, UnevenLightAndFog) {
  Scenario scenario = load_scenario("default");
  scenario.name = "uneven light";
  scenario.optics.gradient_ratio = 0.4;
  scenario.optics.vignette_ratio = 0.3;
  scenario.optics.contrast = 0.5;
  MembraneTracker tracker;
  expect_followed(scenario, test::run_scenario(scenario, tracker, 2), 0.5, 1.5);
}

TEST(Robustness, ABrightnessStepInMidRun) {
  Scenario scenario = load_scenario("default");
  VirtualMicroscope microscope(scenario);
  MembraneTracker tracker;
  std::vector<std::uint8_t> dimmed;
  while (const std::optional<Frame> frame = microscope.next()) {
    ImageView view = view_of(frame->image.get());
    if (frame->frame_index % 60 >= 30) {
      const auto* pixels = static_cast<const std::uint8_t*>(view.data);
      dimmed.assign(pixels, pixels + view.row_bytes * view.height_px);
      for (std::uint8_t& p : dimmed) p = static_cast<std::uint8_t>(p * 7 / 10);
      view.data = dimmed.data();
    }
    const Observation seen = tracker.process(view, frame->time_s, frame->frame_index);
    const test::FrameError e = test::compare(seen, microscope.truth().observation, scenario.image.pixel_size_um);
    ASSERT_GE(e.outer_px, 0.0) << "frame " << frame->frame_index;
    EXPECT_LT(e.outer_px, 0.6) << "frame " << frame->frame_index;
  }
}

TEST(Robustness, AJumpOfThirtyPixelsAndBack) {
  // The same frames seen through a window that jumps: stage knocks.
  Scenario scenario = load_scenario("default");
  VirtualMicroscope microscope(scenario);
  MembraneTracker tracker;
  int bad = 0;
  while (const std::optional<Frame> frame = microscope.next()) {
    ImageView view = view_of(frame->image.get());
    const int shift = frame->frame_index % 40 >= 20 ? 30 : 0;
    view.data = static_cast<const std::uint8_t*>(view.data) + shift;
    view.width_px -= 30;
    const Observation seen = tracker.process(view, frame->time_s, frame->frame_index);
    Observation truth = microscope.truth().observation;
    const Eigen::Vector2d moved(shift * scenario.image.pixel_size_um, 0.0);
    truth.outer->points_um.colwise() -= moved;
    truth.inner->points_um.colwise() -= moved;
    truth.needle->tip_um -= moved;
    truth.center_um -= moved;
    const test::FrameError e = test::compare(seen, truth, scenario.image.pixel_size_um);
    if (e.outer_px < 0.0 || e.outer_px > 1.0) ++bad;
    if (e.confidence > 0.8) {
      EXPECT_LT(e.outer_px, 2.0) << "frame " << frame->frame_index;
    }
  }
  EXPECT_LE(bad, 8);
}

TEST(Robustness, TheCellLeavesAndComesBack) {
  // An empty field in between: lost, then found again with no click.
  Scenario scenario = load_scenario("default");
  scenario.image.duration_s = 1.5;
  VirtualMicroscope microscope(scenario);
  MembraneTracker tracker;
  bool lost = false;
  Observation seen;
  while (const std::optional<Frame> frame = microscope.next()) {
    ImageView view = view_of(frame->image.get());
    std::vector<std::uint8_t> empty(static_cast<std::size_t>(view.row_bytes) * view.height_px, 140);
    if (frame->frame_index >= 10 && frame->frame_index < 20) view.data = empty.data();
    seen = tracker.process(view, frame->time_s, frame->frame_index);
    if (frame->frame_index >= 10 && frame->frame_index < 20) {
      EXPECT_LT(seen.confidence, 0.5) << "frame " << frame->frame_index;
      lost = lost || seen.state == CellState::kLost;
    }
  }
  EXPECT_TRUE(lost);
  EXPECT_NE(seen.state, CellState::kLost);
  EXPECT_LT(test::compare(seen, microscope.truth().observation, scenario.image.pixel_size_um).outer_px, 0.5);
}

}  // namespace
}  // namespace pellucida
