#include "pellucida/mechanics_vtk/MechanicsStep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "MeasuredScenes.h"
#include "SpecimenView.h"
#include "support/TestProfiles.h"

namespace pellucida {
namespace {

using testing::make_scene;
using testing::MeasuringSteps;

// The force needs no surface, and what is only written has the numbers of what is shown.
TEST(MechanicsStep, TheForceComesBeforeTheSurface) {
  MechanicsStep mechanics(load_profile("mouse-oocyte"));
  NodalForces shown, written;
  for (const double depth_um : {0.0, 8.0, 20.0}) {
    const Scene scene = make_scene(depth_um, 0.3, 36, 47);
    Scene bare = scene;
    bare.surface = {};
    const auto measured = mechanics.process(bare);
    ASSERT_TRUE(measured);
    EXPECT_EQ(measured->scene.measurement.contact_force_uN > 0.0, depth_um > 0.0);
    EXPECT_FALSE(measured->scene.model);
    EXPECT_FALSE(written.forces_on(bare.surface, measured->estimate).force_uN);

    Scene surfaced = measured->scene;
    surfaced.surface = scene.surface;
    const Scene drawn = shown.add_to(surfaced, measured->estimate);
    EXPECT_EQ(to_csv(drawn.measurement), to_csv(measured->scene.measurement));
    EXPECT_TRUE(drawn.model);
    const auto surface = drawn.surface.shallow_copy();
    const SurfaceForces forces = written.forces_on(scene.surface, measured->estimate);
    for (vtkDataArray* array : forces.arrays()) {
      ASSERT_TRUE(array);
      vtkDataArray* expected = surface->GetPointData()->GetArray(array->GetName());
      ASSERT_TRUE(expected) << array->GetName();
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
        for (int k = 0; k < array->GetNumberOfComponents(); ++k) {
          EXPECT_EQ(array->GetComponent(i, k), expected->GetComponent(i, k)) << array->GetName() << ' ' << i;
        }
      }
    }
  }
}

TEST(MechanicsStep, AVolumeMeasuredBeforeIsKept) {
  Scene scene = make_scene(5.0, 0.0, 12, 23);
  scene.measurement.volume_um3 = 123456.0;
  MeasuringSteps step(testing::coarse_profile());
  EXPECT_DOUBLE_EQ(step.process(scene)->measurement.volume_um3, 123456.0);
}

// With a wrong pixel size there is no cell of the kind: what was seen instead says why. No cell at all needs no reason.
TEST(MechanicsStep, ACellRefusedForItsSizeIsExplained) {
  for (const double refused_um : {0.0, 150.0}) {
    MechanicsStep mechanics(testing::coarse_profile());
    Scene scene;
    Observation o;
    o.refused_radius_um = refused_um;
    scene.observation = std::make_shared<const Observation>(o);
    const auto measured = mechanics.process(scene);
    ASSERT_TRUE(measured);
    const bool is_explained = measured->scene.remarks.reason.find("150 um") != std::string::npos;
    EXPECT_EQ(is_explained, refused_um > 0.0) << measured->scene.remarks.reason;
    EXPECT_EQ(measured->scene.events.size(), refused_um > 0.0 ? 1U : 0U);
  }
}

TEST(MechanicsStep, AMissingForceIsExplainedOnce) {
  MeasuringSteps step(testing::coarse_profile());
  Scene scene = make_scene(5.0, 0.0, 12, 23);
  Observation o = *scene.observation;
  o.needle.reset();
  scene.observation = std::make_shared<const Observation>(o);
  const auto first = step.process(scene);
  ASSERT_EQ(first->events.size(), 1u);
  EXPECT_EQ(first->events[0].kind, "note");
  EXPECT_NE(first->events[0].detail.find("needle"), std::string::npos);
  EXPECT_TRUE(std::isnan(first->measurement.contact_force_uN));
  // The event once, the reason beside every frame that lacks its force.
  const auto second = step.process(scene);
  EXPECT_TRUE(second->events.empty());
  EXPECT_NE(second->remarks.reason.find("needle"), std::string::npos);
}

// What the contours say of a holding pipette whose width is not seen is a note of the session, once a contact.
TEST(MechanicsStep, SizesByContoursAreANote) {
  const CellReference cell = CellReference::load("specimen-14", 1);
  MechanicsStep mechanics(load_profile("mouse-oocyte"));
  std::vector<Event> notes;
  long frame = 0;
  for (double depth_um = -3.0; depth_um <= 24.0; depth_um += 0.5) {
    Observation o = testing::view_of(cell, std::max(0.0, depth_um), frame++);
    o.rest_inner_radius_um = cell.inner_radius_um();
    o.holder->outer_radius_um = 0.0;
    Scene scene;
    scene.observation = std::make_shared<const Observation>(o);
    const auto measured = mechanics.process(scene);
    ASSERT_TRUE(measured);
    for (const Event& event : measured->scene.events)
      if (event.detail.starts_with("by the contours in contact: zona ")) notes.push_back(event);
  }
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes.front().kind, event_kind::kNote);
  EXPECT_NE(notes.front().detail.find("holding pipette"), std::string::npos);
}

// How a wall stiffens stands beside the force of each frame in contact, and is a note once it is sure.
TEST(MechanicsStep, AWallThatStiffensIsAColumnAndANote) {
  const CellReference cell =
      CellReference::load(PELLUCIDA_SOURCE_DIR "/tests/data/stiffening/specimen-1067", 1);  // b = 0.35
  MechanicsStep mechanics(load_profile("mouse-oocyte"));
  int notes = 0;
  long frame = 0;
  Measurement last;
  for (double depth_um = -3.0; depth_um <= 40.0; depth_um += 0.5) {
    Observation o = testing::view_of(cell, std::max(0.0, depth_um), frame++);
    o.rest_inner_radius_um = cell.inner_radius_um();
    Scene scene;
    scene.observation = std::make_shared<const Observation>(o);
    const auto measured = mechanics.process(scene);
    ASSERT_TRUE(measured);
    last = measured->scene.measurement;
    if (depth_um <= 0.0) {
      EXPECT_TRUE(std::isnan(last.strain_stiffening)) << depth_um;
    }
    for (const Event& event : measured->scene.events)
      notes += event.detail.find("the zona stiffens with strain, b = ") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(notes, 1);
  EXPECT_GT(last.strain_stiffening_lower, 0.0);
  EXPECT_LT(last.strain_stiffening_lower, 0.35);
  EXPECT_GT(last.strain_stiffening_upper, 0.35);
  EXPECT_LT(last.strain_stiffening_upper, 1.5);
}

/// A push along x in frame `frame`, with tip and membrane at these depths.
Scene pushed_scene(double tip_um, double membrane_um, CellState state, long frame) {
  Scene scene = make_scene(membrane_um, 0.0, 12, 23);
  Observation o = *scene.observation;
  o.time_s = static_cast<double>(frame) / 30.0;
  o.frame_index = frame;
  o.state = state;
  o.needle->direction = {-1.0, 0.0};
  o.needle->tip_um = o.center_um + Eigen::Vector2d(52.5 - tip_um, 0.0);
  scene.observation = std::make_shared<const Observation>(o);
  scene.measurement = measurement_from(o);
  return scene;
}

TEST(MechanicsStep, APunctureTheMembraneDoesNotBearOutIsNoEvent) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 12; ++frame) {
    const double depth_um = static_cast<double>(frame);
    step.process(pushed_scene(depth_um, depth_um, CellState::kContact, frame));
  }
  Scene ahead = pushed_scene(21.0, 13.0, CellState::kPunctured, 13);
  ahead.events.push_back({13.0 / 30.0, "puncture", "membrane left at 13.0 um"});
  const auto out = step.process(ahead);
  EXPECT_EQ(out->measurement.state, CellState::kContact);
  EXPECT_EQ(out->contact.state, CellState::kContact);
  EXPECT_GT(out->measurement.contact_force_uN, 0.1);
  ASSERT_EQ(out->events.size(), 1u);
  EXPECT_EQ(out->events[0].kind, "warning");
  EXPECT_NE(out->remarks.warning.find("does not follow"), std::string::npos) << out->remarks.warning;
}

TEST(MechanicsStep, APunctureIsReportedOnceInTheFrameThatShowsIt) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 20; ++frame) {
    const auto out = step.process(
        pushed_scene(1.0 * static_cast<double>(frame), 1.0 * static_cast<double>(frame), CellState::kContact, frame));
    EXPECT_TRUE(out->events.empty()) << frame;
    EXPECT_EQ(out->measurement.state, CellState::kContact);
    EXPECT_GT(out->measurement.stiffness_uN_per_um, 0.0);
    EXPECT_NEAR(out->measurement.lateral_force_uN, 0.0, 1e-5);
  }
  // Before the tracker says so.
  const auto broken = step.process(pushed_scene(21.0, 10.0, CellState::kContact, 21));
  ASSERT_EQ(broken->events.size(), 1u);
  EXPECT_EQ(broken->events[0].kind, "puncture");
  EXPECT_NE(broken->events[0].detail.find("work"), std::string::npos) << broken->events[0].detail;
  EXPECT_EQ(broken->measurement.state, CellState::kPunctured);
  EXPECT_EQ(broken->measurement.contact_force_uN, 0.0);
  // The tracker's own event, a frame later, would be the same puncture again.
  Scene later = pushed_scene(22.0, 4.0, CellState::kPunctured, 22);
  later.events.push_back({22.0 / 30.0, "puncture", "membrane left at 4.0 um"});
  EXPECT_TRUE(step.process(later)->events.empty());
}

TEST(MechanicsStep, ARevokedPunctureIsAnEvent) {
  MeasuringSteps step(testing::coarse_profile());
  for (long frame = 1; frame <= 20; ++frame) {
    const double depth_um = static_cast<double>(frame);
    step.process(pushed_scene(depth_um, depth_um, CellState::kContact, frame));
  }
  ASSERT_EQ(step.process(pushed_scene(21.0, 5.0, CellState::kContact, 21))->measurement.state, CellState::kPunctured);
  for (long frame = 22; frame <= 23; ++frame)
    EXPECT_EQ(step.process(pushed_scene(21.0, 21.0, CellState::kContact, frame))->measurement.state,
              CellState::kPunctured);
  const auto back = step.process(pushed_scene(21.0, 21.0, CellState::kContact, 24));
  EXPECT_EQ(back->measurement.state, CellState::kContact);
  EXPECT_GT(back->measurement.contact_force_uN, 0.1);
  ASSERT_FALSE(back->events.empty());
  EXPECT_EQ(back->events[0].kind, event_kind::kRevoked) << back->events[0].detail;
}

TEST(MechanicsStep, ScenesWithoutCellOrSurfacePassOn) {
  MeasuringSteps step(testing::coarse_profile());
  Scene no_surface = make_scene(5.0, 0.0, 12, 23);
  no_surface.surface = {};
  const auto a = step.process(no_surface);
  ASSERT_TRUE(a.has_value());
  EXPECT_FALSE(a->surface);
  EXPECT_TRUE(a->model);
  EXPECT_GT(a->measurement.contact_force_uN, 0.0);

  Scene no_cell;
  no_cell.observation = std::make_shared<const Observation>();
  const auto b = step.process(no_cell);
  ASSERT_TRUE(b.has_value());
  EXPECT_FALSE(b->model);
  EXPECT_TRUE(std::isnan(b->measurement.contact_force_uN));

  EXPECT_FALSE(step.process(Scene{}).has_value());
}

}  // namespace
}  // namespace pellucida
