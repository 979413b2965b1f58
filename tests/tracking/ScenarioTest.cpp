// The tracker against the virtual microscope's truth, scenario by scenario. Limits are about twice what is measured
// (docs/method.md, 1.8), well within what the product promises.
#include <gtest/gtest.h>

#include "pellucida/core_vtk/SceneData.h"
#include "tracking/PixelView.h"
#include "tracking/ScenarioRun.h"

namespace pellucida {
namespace {

struct ScenarioLimits {
  const char* scenario;
  double outer_rms_px, outer_max_px, inner_rms_px, tip_rms_px, indentation_rms_um;
};

void PrintTo(const ScenarioLimits& limits, std::ostream* out) {
  *out << limits.scenario;
}

class ScenarioTest : public testing::TestWithParam<ScenarioLimits> {};

TEST_P(ScenarioTest, BothMembranesAndTheNeedleAreFollowedThroughout) {
  const ScenarioLimits& limits = GetParam();
  MembraneTracker tracker;
  const std::vector<test::FrameError> errors = test::run_scenario(load_scenario(limits.scenario), tracker);
  ASSERT_GT(errors.size(), 100U);
  const test::ErrorSummary outer = summarize(errors, &test::FrameError::outer_px);
  const test::ErrorSummary inner = summarize(errors, &test::FrameError::inner_px);
  const test::ErrorSummary tip = summarize(errors, &test::FrameError::tip_px);
  const test::ErrorSummary depth = summarize_indentation(errors);
  EXPECT_EQ(outer.missing, 0);
  EXPECT_EQ(inner.missing, 0);
  // With the poor camera the first frame alone may not show the needle clearly enough.
  EXPECT_LE(tip.missing, std::string(limits.scenario) == "noisy" ? 3 : 0);
  EXPECT_LT(outer.rms, limits.outer_rms_px);
  EXPECT_LT(outer.largest, limits.outer_max_px);
  EXPECT_LT(inner.rms, limits.inner_rms_px);
  EXPECT_LT(tip.rms, limits.tip_rms_px);
  EXPECT_LT(depth.rms, limits.indentation_rms_um);

  // Never wrong and sure of itself; the state right but for the few frames a decision takes.
  int differing = 0, bold = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const test::FrameError& e = errors[k];
    bold += e.confident_and_wrong() ? 1 : 0;
    EXPECT_NE(e.state, CellState::kLost) << "frame " << k;
    differing += e.state != e.true_state ? 1 : 0;
  }
  EXPECT_LE(differing, 10);
  EXPECT_EQ(bold, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ScenarioTest,
                         testing::Values(ScenarioLimits{"default", 0.29, 0.47, 0.2, 0.47, 0.21},
                                         ScenarioLimits{"configuration-2", 0.25, 0.45, 0.1, 0.32, 0.29},
                                         ScenarioLimits{"configuration-3", 0.21, 0.39, 0.085, 0.39, 0.33},
                                         ScenarioLimits{"configuration-3-mirrored", 0.21, 0.39, 0.085, 0.41, 0.38},
                                         ScenarioLimits{"puncture", 0.11, 1.0, 0.15, 0.35, 0.26},
                                         ScenarioLimits{"embryo", 0.34, 0.75, 1.36, 0.36, 0.54},
                                         ScenarioLimits{"noisy", 0.27, 0.8, 0.2, 1.0, 0.6},
                                         ScenarioLimits{"needle-from-left-above", 0.21, 0.39, 0.09, 0.21, 0.25}),
                         [](const testing::TestParamInfo<ScenarioLimits>& chosen) {
                           std::string name = chosen.param.scenario;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST(ScenarioContract, EveryFrameOfTheDefaultStaysWithinTheLimits) {
  // Contour below 0.3 px (behind a needle 10 um wide the middle of the dimple can't be seen), tip below 0.55 px, in
  // each frame, not on average. The inner one below 0.4 px: a solid's inner face bulges beside the tip, 0.33 px found.
  MembraneTracker tracker;
  const std::vector<test::FrameError> errors = test::run_scenario(load_scenario("default"), tracker);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    EXPECT_LT(errors[k].outer_px, 0.3) << "frame " << k;
    EXPECT_LT(errors[k].inner_px, 0.4) << "frame " << k;
    EXPECT_LT(errors[k].tip_px, 0.55) << "frame " << k;
    EXPECT_GE(errors[k].tip_px, 0.0) << "frame " << k;
  }
}

TEST(ScenarioContract, ContoursAreOrderedEvenAndStable) {
  MembraneTracker tracker;
  Eigen::Vector2d start_before = Eigen::Vector2d::Zero();
  test::run_scenario(load_scenario("default"), tracker, 1,
                     [&](const Frame&, const Observation& seen, const Truth&, const test::FrameError&) {
                       ASSERT_TRUE(seen.outer && seen.inner);
                       for (const MembraneContour* contour : {&*seen.outer, &*seen.inner}) {
                         const Contour_um& p = contour->points_um;
                         ASSERT_EQ(p.cols(), 192);
                         ASSERT_EQ(contour->sigma_um.size(), p.cols());
                         ASSERT_EQ(contour->confidence.size(), p.cols());
                         double area = 0.0;
                         for (Eigen::Index i = 0; i < p.cols(); ++i) {
                           const Eigen::Index j = (i + 1) % p.cols();
                           area += 0.5 * (p(0, i) * p(1, j) - p(0, j) * p(1, i));
                         }
                         EXPECT_GT(area, 0.0);
                         EXPECT_GT(contour->sigma_um.minCoeff(), 0.0);
                         EXPECT_LE(contour->confidence.maxCoeff(), 1.0);
                         EXPECT_GE(contour->confidence.minCoeff(), 0.0);
                       }
                       // The start follows the needle's axis: it does not wander round the cell.
                       const Eigen::Vector2d start = seen.outer->points_um.col(0);
                       if (seen.frame_index > 0) {
                         EXPECT_LT((start - start_before).norm(), 0.95);
                       }
                       start_before = start;
                     });
}

TEST(ScenarioContract, TheMembraneThatSprangBackIsSeenAtOnce) {
  // Whatever part of its way back the first frame after the break shows.
  for (const double relaxation_s : {0.02, 0.06, 0.15}) {
    for (const double depth_um : {43.0, 43.3, 43.6}) {
      SCOPED_TRACE("relaxation " + std::to_string(relaxation_s) + " s, depth " + std::to_string(depth_um) + " um");
      Scenario scenario = load_scenario("puncture");
      scenario.motion = {.gap_um = 5.0,
                         .approach_speed_um_per_s = 60.0,
                         .indentation_um = 54.0,
                         .indentation_speed_um_per_s = 32.0,
                         .hold_s = 0.1};
      scenario.puncture.indentation_um = depth_um;
      scenario.puncture.relaxation_s = relaxation_s;
      MembraneTracker tracker;
      const std::vector<test::FrameError> errors = test::run_scenario(scenario, tracker);
      int late = 0;
      for (std::size_t k = 0; k < errors.size(); ++k) {
        EXPECT_FALSE(errors[k].confident_and_wrong()) << "frame " << k;
        late += errors[k].true_state == CellState::kPunctured && errors[k].state != CellState::kPunctured ? 1 : 0;
      }
      EXPECT_EQ(errors.back().true_state, CellState::kPunctured);
      EXPECT_LE(late, 2);
    }
  }
}

TEST(ScenarioContract, TheSameFramesGiveTheSameNumbers) {
  Scenario scenario = load_scenario("default");
  scenario.image.duration_s = 1.0;
  MembraneTracker first, second;
  std::vector<Eigen::Matrix2Xd> contours;
  test::run_scenario(scenario, first, 1,
                     [&](const Frame&, const Observation& seen, const Truth&, const test::FrameError&) {
                       contours.push_back(seen.outer->points_um);
                     });
  // A used tracker, after reset, must not remember.
  test::run_scenario(load_scenario("noisy"), second, 20);
  second.reset();
  std::size_t k = 0;
  test::run_scenario(scenario, second, 1,
                     [&](const Frame&, const Observation& seen, const Truth&, const test::FrameError&) {
                       ASSERT_TRUE(seen.outer.has_value());
                       EXPECT_TRUE(seen.outer->points_um == contours.at(k++));
                     });
}

TEST(ScenarioContract, TheCellLeavesAndComesBack) {
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
  EXPECT_LT(test::compare(seen, microscope.truth().observation, scenario.image.pixel_size_um).outer_px, 0.085);
}

// A cell that is lost while the needle pushes it, and found again with its dimple, is the same one: where it lies at
// rest is known, and one frame of it is no puncture.
TEST(Scenarios, ACellLostInContactAndFoundAgainKeepsItsRestAndItsContact) {
  constexpr double kDeep_um = 25.0;
  constexpr int kDark_frames = 5;
  TrackerOptions options;
  options.detection = TrackerOptions::Detection::kLines;
  MembraneTracker tracker(options);
  VirtualMicroscope microscope(load_scenario("default"));
  int dark = 0, judged = 0;
  bool was_lost = false;
  while (const std::optional<Frame> frame = microscope.next()) {
    const Truth truth = microscope.truth();
    if (truth.observation.state == CellState::kPunctured) break;
    const ImageView view = view_of(frame->image.get());
    const bool is_dark = truth.observation.indentation_um > kDeep_um && dark < kDark_frames;
    const std::vector<std::uint8_t> nothing(static_cast<std::size_t>(view.width_px * view.height_px), 20);
    ImageView shown = view;
    if (is_dark) {
      ++dark;
      shown = test::view_of_bytes(nothing, view.width_px, view.height_px, view.pixel_size_um);
    }
    const Observation seen = tracker.process(shown, frame->time_s, frame->frame_index);
    was_lost = was_lost || (dark > 0 && seen.state == CellState::kLost);
    if (dark < kDark_frames || is_dark || !seen.outer) continue;
    ++judged;
    ASSERT_EQ(seen.state, CellState::kContact) << "frame " << frame->frame_index;
    // In the first frame the contour is on its way into the dimple.
    const double allowed_um = judged == 1 ? 5.0 : 1.0;
    EXPECT_NEAR(seen.indentation_um, truth.observation.indentation_um, allowed_um) << "frame " << frame->frame_index;
    EXPECT_NEAR(seen.rest_outer_radius_um, truth.observation.rest_outer_radius_um, 0.3);
    if (judged == 20) break;
  }
  EXPECT_TRUE(was_lost);
  EXPECT_EQ(judged, 20);
}

}  // namespace
}  // namespace pellucida
