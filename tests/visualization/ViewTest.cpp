#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cmath>
#include <memory>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "visualization/Views.h"

namespace pellucida {
namespace {

using test::kHeight_px, test::kWidth_px, test::Views;

TEST_F(Views, FeedShowsContoursToolsAndModelEachInItsColour) {
  FeedView feed(source);
  feed.add_to(window);
  const auto with = shot();
  feed.show_contours(false);
  feed.show_tools(false);
  feed.show_model_section(false);
  const auto without = shot();
  for (const Color& c : {palette::kOuter, palette::kInner, palette::kNeedle, palette::kHolder, palette::kModel}) {
    EXPECT_GT(count_near(with, c), 150) << c.css();
    EXPECT_LT(count_near(without, c), 5) << c.css();
  }
  window->Finalize();
}

TEST_F(Views, FeedShowsThePlanWhileThereIsOne) {
  FeedView feed(source);
  feed.add_to(window);
  EXPECT_LT(count_near(shot(), palette::kPlan), 5);
  PlanMarks plan;
  plan.approach_um = {390.0, 200.0};
  plan.entry_um = {348.0, 200.0};
  plan.target_um = {300.0, 200.0};
  plan.depth_stop_um = {306.0, 200.0};
  plan.corridor_um = 3.0;
  feed.set_plan(plan);
  EXPECT_GT(count_near(shot(), palette::kPlan), 100);
  feed.set_plan(std::nullopt);
  EXPECT_LT(count_near(shot(), palette::kPlan), 5);
  window->Finalize();
}

// Of a needle that isn't in view the manipulator still knows: an arrow at that edge.
TEST_F(Views, FeedPointsAtANeedleBeyondItsEdge) {
  Scene scene = test::synthetic_scene(25.0);
  scene.tools = {};
  scene.observation.reset();
  source->SetScene(scene);
  FeedView feed(source);
  feed.show_contours(false);
  feed.show_model_section(false);
  feed.add_to(window);
  EXPECT_LT(count_near(shot(), palette::kNeedle), 5);
  const auto at_right = [&] { return count_near(shot(), palette::kNeedle, 0.12, kWidth_px - 60, kWidth_px); };
  feed.set_reported_tip(Eigen::Vector2d(5000.0, 200.0));
  EXPECT_GT(at_right(), 60);
  feed.set_reported_tip(Eigen::Vector2d(-5000.0, 200.0));
  EXPECT_LT(at_right(), 5);
  EXPECT_GT(count_near(shot(), palette::kNeedle), 60);
  feed.set_reported_tip(Eigen::Vector2d(300.0, 200.0));
  EXPECT_LT(count_near(shot(), palette::kNeedle), 5);
  window->Finalize();
}

TEST_F(Views, FeedShowsWhatAClickIsWaitedForAndWhereOnePointed) {
  FeedView feed(source);
  feed.add_to(window);
  EXPECT_LT(count_near(shot(), palette::kWarning, 0.03), 5);
  feed.set_prompt("Click inside the cell");
  const int prompted = count_near(shot(), palette::kWarning, 0.03);
  EXPECT_GT(prompted, 2000);
  feed.set_prompt("");
  feed.set_hints({{{300.0, 200.0}, "tip"}});
  const int marked = count_near(shot(), palette::kWarning, 0.03);
  EXPECT_GT(marked, 60);
  EXPECT_LT(marked, prompted);
  window->Finalize();
}

TEST_F(Views, FeedTellsWhereAPlaceOfTheViewLies) {
  FeedView feed(source);
  feed.add_to(window);
  shot();
  const Eigen::Vector2d middle = feed.place_um(0.5 * kWidth_px, 0.5 * kHeight_px, kHeight_px);
  const Eigen::Vector2d right = feed.place_um(0.5 * kWidth_px + 100.0, 0.5 * kHeight_px, kHeight_px);
  const Eigen::Vector2d below = feed.place_um(0.5 * kWidth_px, 0.5 * kHeight_px + 100.0, kHeight_px);
  EXPECT_GT(right.x(), middle.x() + 10.0);
  EXPECT_NEAR(right.y(), middle.y(), 1e-6);
  EXPECT_NEAR(below.y() - middle.y(), right.x() - middle.x(), 1e-6);
  window->Finalize();
}

TEST_F(Views, FeedHasXToTheRightAndYDown) {
  FeedView feed(source);
  feed.show_contours(false);
  feed.show_model_section(false);
  feed.add_to(window);
  const auto image = shot();
  // The needle comes from the right, the holder from the left.
  double needle_x = 0.0;
  double holder_x = 0.0;
  int needle_count = 0;
  int holder_count = 0;
  for (int y = 60; y < kHeight_px - 110; ++y) {
    for (int x = 0; x < kWidth_px; ++x) {
      const double red = image->GetScalarComponentAsDouble(x, y, 0, 0);
      const double green = image->GetScalarComponentAsDouble(x, y, 0, 1);
      const double blue = image->GetScalarComponentAsDouble(x, y, 0, 2);
      if (red > 200 && green < 130) {
        needle_x += x;
        ++needle_count;
      }
      if (green > 190 && red < 170 && blue < 170) {
        holder_x += x;
        ++holder_count;
      }
    }
  }
  ASSERT_GT(needle_count, 0);
  ASSERT_GT(holder_count, 0);
  EXPECT_GT(needle_x / needle_count, holder_x / holder_count + 0.3 * kWidth_px);
  window->Finalize();
}

TEST_F(Views, FeedWaitsVisiblyForTheFirstFrame) {
  source->SetScene(Scene{});
  FeedView feed(source);
  feed.add_to(window);
  EXPECT_GT(count_near(shot(), palette::kTextDim), 50);
  window->Finalize();
}

TEST_F(Views, MembranesDrawAScenePartByPart) {
  // A surface without forces, a scene without tools, nothing at all: no view may stumble.
  Scene scene = test::synthetic_scene(25.0);
  MembraneView view(source);
  FeedView feed(source);
  view.add_to(window, {0.5, 0.0, 1.0, 1.0});
  feed.add_to(window, {0.0, 0.0, 0.5, 1.0});
  for (int part = 0; part < 5; ++part) {
    if (part == 0) scene.model = {};
    if (part == 1) scene.tools = {};
    if (part == 2) scene.observation.reset();
    if (part == 3) scene.surface = {};
    if (part == 4) scene = Scene{};
    source->SetScene(scene);
    view.refresh();
    feed.refresh();
    window->Render();
  }
  source->SetScene(test::synthetic_scene(10.0));
  view.refresh();
  feed.refresh();
  window->Render();
  window->Finalize();
}

}  // namespace
}  // namespace pellucida
