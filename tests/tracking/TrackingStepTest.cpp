#include "pellucida/tracking_vtk/TrackingStep.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>

#include <cmath>

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
