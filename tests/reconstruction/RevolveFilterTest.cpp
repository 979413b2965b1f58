#include "pellucida/reconstruction_vtk/RevolveFilter.h"

#include <gtest/gtest.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/reconstruction_vtk/ReconstructionStep.h"
#include "reconstruction/TestContours.h"

namespace pellucida {
namespace {

Observation cell_at_rest() {
  Observation o;
  o.time_s = 2.0;
  o.frame_index = 60;
  o.center_um = {100.0, 100.0};
  o.axis = {1.0, 0.0};
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.outer =
      MembraneContour{.membrane = Membrane::kOuter, .points_um = test::ellipse(400, o.center_um, o.axis, 52.5, 52.5)};
  o.inner =
      MembraneContour{.membrane = Membrane::kInner, .points_um = test::ellipse(400, o.center_um, o.axis, 47.5, 47.5)};
  return o;
}

Scene scene_of(const Observation& observation) {
  Scene scene;
  scene.observation = std::make_shared<const Observation>(observation);
  scene.membranes = Frozen<vtkPolyData>(make_membranes(observation));
  return scene;
}

TEST(RevolveFilter, BothMembranesWithTheContractsArrays) {
  ReconstructionStep step({.step_deg = 30.0, .meridian_point_count = 25});
  const auto scene = step.process(scene_of(cell_at_rest()));
  ASSERT_TRUE(scene);
  const auto surface = scene->surface.shallow_copy();
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->GetNumberOfPoints(), 2 * (2 + 23 * 12));
  EXPECT_EQ(surface->GetPointData()->GetArray("membrane")->GetRange()[1], 1.0);
  EXPECT_LT(surface->GetPointData()->GetArray("displacement_um")->GetRange(-1)[1], 0.0033);
  EXPECT_DOUBLE_EQ(stamped_time_s(surface), 2.0);
  EXPECT_NEAR(scene->measurement.volume_um3 / (4.0 / 3.0 * std::numbers::pi * 52.5 * 52.5 * 52.5), 1.0, 0.008);

  // VTK itself sees no open and no non-manifold edge.
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
}

TEST(RevolveFilter, NoContoursIsNoFailure) {
  ReconstructionStep step({});
  const auto scene = step.process(scene_of(Observation{}));
  ASSERT_TRUE(scene);
  EXPECT_FALSE(scene->surface);
  EXPECT_TRUE(scene->events.empty());
}

TEST(RevolveFilter, AContourThatCannotBeRevolvedIsReportedOnce) {
  Observation o = cell_at_rest();
  o.center_um = {500.0, 100.0};
  ReconstructionStep step({});
  const auto first = step.process(scene_of(o));
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->surface);
  ASSERT_EQ(first->events.size(), 1U);
  EXPECT_NE(first->events[0].detail.find("centre"), std::string::npos);
  EXPECT_TRUE(step.process(scene_of(o))->events.empty());
}

}  // namespace
}  // namespace pellucida
