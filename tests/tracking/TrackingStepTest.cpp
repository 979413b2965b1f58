#include "pellucida/tracking_vtk/TrackingStep.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>

#include <cmath>

#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/simulation/VirtualMicroscope.h"

namespace pellucida {
namespace {

TEST(TrackingStep, ASceneWithoutAFrameFailsWithTheReason) {
  TrackingStep step;
  const auto result = step.process(Scene{});
  ASSERT_FALSE(result.has_value());
  EXPECT_NE(result.error().reason.find("no frame"), std::string::npos);
}

TEST(TrackingStep, FillsTheSceneAndKeepsWhatWasThere) {
  const auto microscope = open_virtual("default");
  const Frame frame = *microscope->next();
  Scene scene;
  scene.arrival_s = 3.25;
  scene.frame = frame.image;
  scene.events.push_back({0.0, "note", "before"});
  TrackingStep step;
  const auto result = step.process(scene);
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->arrival_s, 3.25);
  EXPECT_EQ(result->frame.get(), scene.frame.get());
  ASSERT_TRUE(result->observation);
  ASSERT_TRUE(result->membranes && result->tools);
  EXPECT_EQ(result->membranes.shallow_copy()->GetNumberOfCells(), 2);
  EXPECT_EQ(stamped_frame_index(result->membranes.get()), frame.frame_index);
  EXPECT_EQ(result->measurement.state, CellState::kFree);
  EXPECT_TRUE(std::isfinite(result->measurement.tip_x_um));
  ASSERT_EQ(result->events.size(), 2U);
  EXPECT_EQ(result->events[0].kind, "note");
  EXPECT_EQ(result->events[1].kind, "found");
}

TEST(TrackingStep, TellsTheStoryOfAPuncture) {
  const auto microscope = open_virtual("puncture");
  TrackingStep step;
  std::vector<std::string> story;
  double puncture_s = 0.0, true_puncture_s = 0.0;
  while (const std::optional<Frame> frame = microscope->next()) {
    Scene scene;
    scene.frame = frame->image;
    const auto result = step.process(scene);
    ASSERT_TRUE(result.has_value());
    for (const Event& event : result->events) {
      story.push_back(event.kind);
      EXPECT_EQ(event.time_s, result->observation->time_s);
      if (event.kind == "puncture") puncture_s = event.time_s;
    }
    if (true_puncture_s == 0.0 && microscope->truth().observation.state == CellState::kPunctured)
      true_puncture_s = frame->time_s;
  }
  EXPECT_EQ(story, (std::vector<std::string>{"found", "contact", "puncture", "release"}));
  EXPECT_NEAR(puncture_s, true_puncture_s, 0.07);
}

TEST(TrackingStep, TheWayAManipulatorWentIsEvidenceAndStaysInTheRow) {
  const auto microscope = open_virtual("default");
  TrackingStep step, without;
  int told = 0;
  for (int k = 0; k < 60; ++k) {
    Scene scene;
    scene.frame = microscope->next()->image;
    ASSERT_FALSE(without.process(scene)->observation->needle->evidence & kCommandedMotion);
    const PlainVector3 tip_um = microscope->truth().tip_um;
    scene.measurement.manipulator_x_um = 500.0 + tip_um.x;
    scene.measurement.manipulator_y_um = tip_um.y;
    const auto result = step.process(scene);
    EXPECT_EQ(result->measurement.manipulator_x_um, 500.0 + tip_um.x);
    EXPECT_EQ(result->measurement.manipulator_y_um, tip_um.y);
    told += result->observation->needle->evidence & kCommandedMotion ? 1 : 0;
    EXPECT_LT((result->observation->needle->tip_um - tip_um.eigen().head<2>()).norm(), 0.6) << k;
  }
  EXPECT_GT(told, 30);
}

// A film with a second cell beside the one that is held.
class Hints : public testing::Test {
 protected:
  Hints() : microscope_(with_bystander()) {}

  static Scenario with_bystander() {
    Scenario scenario = load_scenario("default");
    scenario.bystander.cell_radius_um = 45.0;
    scenario.bystander.cell_x_um = kOther_um.x();
    scenario.bystander.cell_y_um = kOther_um.y();
    return scenario;
  }

  Scene next() {
    Scene scene;
    scene.frame = microscope_.next()->image;
    auto result = step_.process(scene);
    EXPECT_TRUE(result.has_value());
    if (result->observation->state != CellState::kNoCell && result->observation->state != CellState::kLost)
      held_um_ = result->observation->center_um;
    return *result;
  }
  static std::vector<std::string> hints_in(const Scene& scene) {
    std::vector<std::string> details;
    for (const Event& event : scene.events) {
      if (event.kind == event_kind::kHint) details.push_back(event.detail);
    }
    return details;
  }
  void point(PersonHint::Kind kind, const Eigen::Vector2d& place_um, double since_s = 0.0) {
    step_.add_hint({.kind = kind, .x_um = place_um.x(), .y_um = place_um.y(), .since_s = since_s});
  }
  static bool has_cell(const Scene& scene) {
    return scene.observation->state != CellState::kNoCell && scene.observation->state != CellState::kLost;
  }

  inline static const Eigen::Vector2d kOther_um{480.0, 80.0};
  VirtualMicroscope microscope_;
  TrackingStep step_;
  Eigen::Vector2d held_um_ = Eigen::Vector2d::Zero();
};

TEST_F(Hints, AClickChoosesTheCellAndTakingItBackTheUsualOne) {
  next();
  const Eigen::Vector2d usual_um = held_um_;
  ASSERT_GT((usual_um - kOther_um).norm(), 100.0);
  point(PersonHint::Kind::kCell, kOther_um + Eigen::Vector2d(10.0, 5.0));
  const Scene hinted = next();
  ASSERT_EQ(hints_in(hinted).size(), 1U);
  EXPECT_EQ(hints_in(hinted)[0], "cell at 490.000 85.000 um: found");
  EXPECT_LT((held_um_ - kOther_um).norm(), 5.0);
  EXPECT_TRUE(hints_in(next()).empty());
  EXPECT_LT((held_um_ - kOther_um).norm(), 5.0);
  point(PersonHint::Kind::kTakeBack, {0.0, 0.0});
  EXPECT_EQ(hints_in(next()).size(), 1U);
  EXPECT_LT((held_um_ - usual_um).norm(), 5.0);
}

TEST_F(Hints, WhatIsNoCellIsNotTakenForOneAgainUntilThatIsTakenBack) {
  next();
  const Eigen::Vector2d usual_um = held_um_;
  point(PersonHint::Kind::kNoCell, usual_um);
  for (int k = 0; k < 20; ++k) {
    const Scene scene = next();
    if (has_cell(scene)) {
      EXPECT_GT((scene.observation->center_um - usual_um).norm(), 100.0);
    }
  }
  point(PersonHint::Kind::kTakeBack, {0.0, 0.0});
  EXPECT_TRUE(has_cell(next()));
  EXPECT_LT((held_um_ - usual_um).norm(), 5.0);
}

TEST_F(Hints, ACellHintOverrulesAnEarlierOne) {
  next();
  const Eigen::Vector2d usual_um = held_um_;
  point(PersonHint::Kind::kNoCell, usual_um);
  next();
  point(PersonHint::Kind::kCell, usual_um);
  EXPECT_TRUE(has_cell(next()));
  EXPECT_LT((held_um_ - usual_um).norm(), 5.0);
}

TEST_F(Hints, APlaceWithoutACellIsSaidSo) {
  next();
  point(PersonHint::Kind::kCell, {30.0, 380.0});
  EXPECT_NE(hints_in(next()).at(0).find("nothing like a cell"), std::string::npos);
}

TEST_F(Hints, TheTipIsWhereOnePoints) {
  Scene scene = next();
  ASSERT_TRUE(scene.observation->needle);
  const Eigen::Vector2d truth_um = microscope_.truth().observation.needle->tip_um;
  point(PersonHint::Kind::kNeedleTip, truth_um + Eigen::Vector2d(3.0, -2.0));
  scene = next();
  EXPECT_NE(hints_in(scene).at(0).find("followed"), std::string::npos) << hints_in(scene)[0];
  ASSERT_TRUE(scene.observation->needle);
  EXPECT_LT((scene.observation->needle->tip_um - microscope_.truth().observation.needle->tip_um).norm(), 2.0);

  // Where there is none the needle stays what it was.
  point(PersonHint::Kind::kNeedleTip, {60.0, 370.0});
  scene = next();
  EXPECT_NE(hints_in(scene).at(0).find("no straight shaft"), std::string::npos) << hints_in(scene)[0];
  ASSERT_TRUE(scene.observation->needle);
  EXPECT_LT((scene.observation->needle->tip_um - microscope_.truth().observation.needle->tip_um).norm(), 2.0);
}

TEST_F(Hints, AnOutlineDrawnRoundlyChoosesTheCell) {
  next();
  std::vector<PersonHint::Place_um> drawn;
  for (int k = 0; k < 14; ++k) {
    const double angle_rad = 0.44 * k, radius_um = 45.0 * (1.05 + 0.06 * std::cos(2.0 * angle_rad));
    drawn.push_back(
        {kOther_um.x() + 3.0 + radius_um * std::cos(angle_rad), kOther_um.y() - 2.0 - radius_um * std::sin(angle_rad)});
  }
  step_.add_hint(*outline_hint(drawn));
  // Each is answered for itself.
  point(PersonHint::Kind::kHolder, {30.0, 380.0});
  const Scene hinted = next();
  ASSERT_EQ(hints_in(hinted).size(), 2U);
  EXPECT_TRUE(hints_in(hinted)[1].ends_with("um: no straight pipette was found there")) << hints_in(hinted)[1];
  EXPECT_TRUE(hints_in(hinted)[0].ends_with(" um: found")) << hints_in(hinted)[0];
  EXPECT_LT((held_um_ - kOther_um).norm(), 2.0);
  EXPECT_NEAR(hinted.observation->rest_outer_radius_um, 45.0, 2.5);

  PersonHint two_corners{.kind = PersonHint::Kind::kCellOutline};
  two_corners.outline_um = {{1.0, 1.0}, {2.0, 2.0}};
  EXPECT_THROW(step_.add_hint(two_corners), UsageError);
}

TEST_F(Hints, TheHolderIsWhereOnePoints) {
  const Scene first = next();
  ASSERT_TRUE(first.observation->holder);
  const Eigen::Vector2d mouth_um = first.observation->holder->mouth_um, center_um = held_um_;
  const Eigen::Vector2d along = (mouth_um - center_um).normalized();
  point(PersonHint::Kind::kHolder, mouth_um + 15.0 * along);
  const Scene pointed = next();
  EXPECT_TRUE(hints_in(pointed).at(0).ends_with("um: followed")) << hints_in(pointed)[0];
  ASSERT_TRUE(pointed.observation->holder);
  EXPECT_LT((pointed.observation->holder->mouth_um - mouth_um).norm(), 1.0);
  EXPECT_LT((held_um_ - center_um).norm(), 0.3);

  // Where there is none, or inside the cell, the holder stays what it was.
  for (const Eigen::Vector2d& place : {Eigen::Vector2d(60.0, 370.0), center_um}) {
    point(PersonHint::Kind::kHolder, place);
    const Scene scene = next();
    EXPECT_NE(hints_in(scene).at(0).find("no straight pipette"), std::string::npos) << hints_in(scene)[0];
    ASSERT_TRUE(scene.observation->holder);
    EXPECT_LT((scene.observation->holder->mouth_um - mouth_um).norm(), 1.0);
  }
}

// The depth goes on from the cell at rest, which is what it was.
TEST_F(Hints, AHolderPointedAtInContactLeavesTheDepthAsItIs) {
  Scene scene = next();
  for (int k = 0; k < 80; ++k) scene = next();
  ASSERT_EQ(scene.observation->state, CellState::kContact);
  const Eigen::Vector2d mouth_um = scene.observation->holder->mouth_um;
  point(PersonHint::Kind::kHolder, mouth_um + 15.0 * (mouth_um - held_um_).normalized());
  for (int k = 0; k < 20; ++k) {
    scene = next();
    EXPECT_NEAR(scene.observation->indentation_um, microscope_.truth().observation.indentation_um, 1.0) << k;
  }
}

TEST_F(Hints, AHintWaitsForItsFrame) {
  next();
  const double rate_hz = microscope_.info().frame_rate_hz;
  point(PersonHint::Kind::kCell, kOther_um, 3.0 / rate_hz);
  EXPECT_TRUE(hints_in(next()).empty());
  EXPECT_TRUE(hints_in(next()).empty());
  EXPECT_EQ(hints_in(next()).size(), 1U);
  EXPECT_THROW(point(PersonHint::Kind::kCell, {std::nan(""), 0.0}), UsageError);
}

TEST(TrackingStep, EventsOfEachChange) {
  Observation now;
  now.state = CellState::kNoCell;
  EXPECT_FALSE(event_of_change(std::nullopt, now));
  EXPECT_FALSE(event_of_change(CellState::kNoCell, now));
  now.state = CellState::kFree;
  EXPECT_EQ(event_of_change(std::nullopt, now)->kind, "found");
  EXPECT_EQ(event_of_change(CellState::kLost, now)->kind, "found");
  EXPECT_EQ(event_of_change(CellState::kContact, now)->kind, "release");
  EXPECT_FALSE(event_of_change(CellState::kFree, now));
  now.state = CellState::kContact;
  EXPECT_EQ(event_of_change(CellState::kFree, now)->kind, "contact");
  now.state = CellState::kPunctured;
  EXPECT_EQ(event_of_change(CellState::kContact, now)->kind, "puncture");
  now.state = CellState::kLost;
  EXPECT_EQ(event_of_change(CellState::kContact, now)->kind, "lost");
}

}  // namespace
}  // namespace pellucida
