#include "pellucida/visualization_vtk/MembraneView.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "ColorMap.h"
#include "pellucida/core_vtk/SceneData.h"
#include "visualization/Views.h"

namespace pellucida {
namespace {

using test::kHeight_px, test::kWidth_px, test::Views;

class MembraneViews : public Views {
 protected:
  // The same scene in another state, or with another force.
  void change(const std::function<void(Scene&)>& how) {
    Scene scene = source->GetScene();
    how(scene);
    source->SetScene(scene);
    view.refresh();
  }
  // Arrays of the surface changed in place, in a copy.
  void change_surface(const std::function<void(vtkPointData&)>& how) {
    change([&](Scene& scene) {
      auto surface = scene.surface.shallow_copy();
      how(*surface->GetPointData());
      scene.surface = Frozen<vtkPolyData>(surface);
    });
  }
  static void scale_array(vtkPointData& data, const char* name, double factor) {
    vtkNew<vtkDoubleArray> scaled;
    scaled->DeepCopy(data.GetArray(name));
    scaled->SetName(name);
    for (vtkIdType i = 0; i < scaled->GetNumberOfValues(); ++i) scaled->SetValue(i, factor * scaled->GetValue(i));
    data.AddArray(scaled);
  }

  MembraneView view{source};
};

TEST_F(MembraneViews, ShowTheInnerBodyAndColouredArrows) {
  view.set_node_force(NodeForceKind::kMembrane);
  view.add_to(window);
  const auto with = shot();
  view.show_arrows(false);
  const auto without = shot();
  // Arrows bring the force scale's magenta, which nothing else has.
  const Color magenta = Color::from_hex(0xDB4D9F);
  EXPECT_GT(count_near(with, magenta), count_near(without, magenta) + 100);
  // The picture is far from empty: most of its middle differs from the ground.
  int lit = 0;
  for (int y = kHeight_px / 4; y < 3 * kHeight_px / 4; ++y) {
    for (int x = kWidth_px / 4; x < 3 * kWidth_px / 4; ++x)
      lit += without->GetScalarComponentAsDouble(x, y, 0, 0) > 70.0;
  }
  EXPECT_GT(lit, kWidth_px * kHeight_px / 16);
  window->Finalize();
}

// Through the inner membrane, which is clear then.
TEST_F(MembraneViews, ADropletIsSeenInTheCell) {
  view.show_arrows(false);
  view.show_tools(false);
  view.add_to(window);
  const auto colored = [&] {
    const auto image = shot();
    int count = 0;
    for (int y = 0; y < kHeight_px; ++y) {
      for (int x = 0; x < kWidth_px; ++x) {
        const auto part = [&](int k) { return image->GetScalarComponentAsDouble(x, y, 0, k); };
        count += part(1) > part(0) + 15.0 && part(1) > part(2) + 4.0;  // greener than all else here
      }
    }
    return count;
  };
  const int without = colored();
  const Observation& seen = *view.scene().observation;
  view.set_droplets({{{seen.center_um.x(), seen.center_um.y(), 0.0}, 0.3 * seen.rest_outer_radius_um, "9.9 pL"}});
  view.refresh();
  EXPECT_GT(colored(), without + 500);
  view.set_droplets({});
  view.refresh();
  EXPECT_EQ(colored(), without);
  window->Finalize();
}

// Shades and what lies behind would lead to colours that the scale doesn't have.
TEST_F(MembraneViews, AColouredSurfaceHasTheColoursOfItsScale) {
  view.show_arrows(false);
  view.show_tools(false);
  view.add_to(window);
  const auto share_on_scale = [&](vtkImageData* image, ColorMapKind kind) {
    int count = 0, all = 0;
    for (int y = kHeight_px / 3; y < 2 * kHeight_px / 3; ++y) {
      for (int x = 2 * kWidth_px / 5; x < 3 * kWidth_px / 5; ++x, ++all) {
        double least = 1.0;
        for (int i = 0; i <= 60; ++i) {
          const Color c = color_at(kind, i / 60.0);
          double off = 0.0;
          for (int k = 0; k < 3; ++k) {
            off = std::max(off, std::abs(image->GetScalarComponentAsDouble(x, y, 0, k) / 255.0 - c.data()[k]));
          }
          least = std::min(least, off);
        }
        count += least < 0.1;
      }
    }
    return static_cast<double>(count) / all;
  };
  EXPECT_LT(share_on_scale(shot(), ColorMapKind::kSurface), 0.5);
  view.set_coloring(SurfaceColoring::kDisplacement);
  EXPECT_GT(share_on_scale(shot(), ColorMapKind::kSurface), 0.9);
  for (const SurfaceColoring coloring : {SurfaceColoring::kTension, SurfaceColoring::kAreaStrain}) {
    view.set_coloring(coloring);
    EXPECT_GT(share_on_scale(shot(), ColorMapKind::kPull), 0.9) << coloring_name(coloring);
  }
  view.set_coloring(SurfaceColoring::kPlain);
  EXPECT_LT(share_on_scale(shot(), ColorMapKind::kSurface), 0.5);
  window->Finalize();
}

TEST_F(MembraneViews, WhereNothingPullsATautSurfaceIsGrey) {
  view.show_arrows(false);
  view.show_tools(false);
  view.set_coloring(SurfaceColoring::kTension);
  view.add_to(window);
  const Color zero = color_at(ColorMapKind::kPull, 0.5);
  const int before = count_near(shot(), zero, 0.06);
  change_surface([](vtkPointData& data) { scale_array(data, array_name::kTension, 0.0); });
  EXPECT_GT(count_near(shot(), zero, 0.15), std::max(before, 8000));
  window->Finalize();
}

TEST_F(MembraneViews, TheModelsMeshIsShownOnRequest) {
  view.show_arrows(false);
  view.add_to(window);
  const int before = count_near(shot(), palette::kModel);
  view.show_model(true);
  EXPECT_GT(count_near(shot(), palette::kModel), before + 250);
  change([](Scene& scene) { scene.model = {}; });
  EXPECT_LE(count_near(shot(), palette::kModel), before + 5);
  window->Finalize();
}

TEST_F(MembraneViews, PlanAndNeedleAreSeenInsideTheCell) {
  view.show_arrows(false);
  view.add_to(window);
  const int before = count_near(shot(), palette::kPlan);
  PlanMarks plan;
  plan.approach_um = {390.0, 200.0};
  plan.entry_um = {348.0, 200.0};
  plan.target_um = {290.0, 200.0};
  plan.depth_stop_um = {286.0, 200.0};
  view.set_plan(plan);
  EXPECT_GT(count_near(shot(), palette::kPlan), before + 60);
  EXPECT_LT(count_near(shot(), palette::kNeedle, 0.08), 5);
  change([](Scene& scene) { scene.measurement.state = CellState::kPunctured; });
  EXPECT_GT(count_near(shot(), palette::kNeedle, 0.08), 40);
  window->Finalize();
}

// Seen from its end the bold arrow is a ring with a dot in it, or a cross, whatever lies before it.
TEST_F(MembraneViews, TheBoldArrowIsReadFromItsEndToo) {
  view.show_arrows(false);
  view.add_to(window);
  shot();
  vtkCamera* camera = view.renderer()->GetActiveCamera();
  double middle_um[3];
  camera->GetFocalPoint(middle_um);
  for (const double side : {1.0, -1.0}) {
    camera->SetPosition(middle_um[0] + side * 400.0, middle_um[1] - 10.0, middle_um[2]);
    camera->SetViewUp(0.0, -1.0, 0.0);
    EXPECT_GT(count_near(shot(), palette::kContactForce, 0.05, kWidth_px / 3, 2 * kWidth_px / 3), 120) << side;
  }
  window->Finalize();
}

TEST_F(MembraneViews, TheToolsForcesAreWrittenBesideTheirArrows) {
  double sum_uN = 0.0;
  vtkDataArray* holder = source->GetScene().surface.shallow_copy()->GetPointData()->GetArray(array_name::kHolderForce);
  for (vtkIdType i = 0; i < holder->GetNumberOfTuples(); ++i) sum_uN += holder->GetComponent(i, 0);
  EXPECT_EQ(view.contact_label(), "2.50 µN");
  ASSERT_FALSE(view.holder_label().empty());
  EXPECT_NEAR(std::strtod(view.holder_label().c_str(), nullptr), sum_uN, 0.006);
  view.set_node_force(NodeForceKind::kPressure);
  EXPECT_TRUE(view.holder_label().empty());
  EXPECT_FALSE(view.contact_label().empty());
}

TEST_F(MembraneViews, WhatASessionLacksIsSaidAndNotDrawn) {
  EXPECT_FALSE(view.lacks_node_force());
  change_surface([](vtkPointData& data) {
    data.RemoveArray(array_name::kNeedleForce);
    data.RemoveArray(array_name::kHolderForce);
  });
  EXPECT_TRUE(view.lacks_node_force());
  view.set_node_force(NodeForceKind::kMembrane);
  EXPECT_FALSE(view.lacks_node_force());
  view.add_to(window);
  shot();
  window->Finalize();
}

TEST_F(MembraneViews, AScaleThatGrowsSaysSo) {
  view.set_node_force(NodeForceKind::kMembrane);
  view.add_to(window);
  // The arrows' own scale has a similar colour.
  const auto told = [&] { return count_near(shot(), palette::kWarning, 0.05, kWidth_px / 2); };
  change_surface([](vtkPointData& data) { scale_array(data, array_name::kForce, 30.0); });
  const int with = told();
  change([](Scene& scene) { scene.measurement.time_s += 5.0; });
  EXPECT_GT(with, told() + 40);
  window->Finalize();
}

TEST_F(MembraneViews, BarsAndGreyAreExplainedBelowTheScale) {
  view.set_node_force(NodeForceKind::kMembrane);
  view.add_to(window);
  const Color unsure = dark_theme().unsure;
  view.show_arrows(false);
  const int without = count_near(shot(), unsure, 0.015, kWidth_px / 2);
  view.show_arrows(true);
  // Sigma as large as the force: no colour is left.
  change_surface([](vtkPointData& data) { scale_array(data, array_name::kForceSigma, 1000.0); });
  EXPECT_GT(count_near(shot(), unsure, 0.015, kWidth_px / 2), without + 100);
  const Color magenta = Color::from_hex(0xDB4D9F);
  EXPECT_LT(count_near(shot(), magenta), 20);
  view.show_error_bars(true);
  shot();
  window->Finalize();
}

TEST_F(MembraneViews, ANodeIsFoundUnderTheMouseAndNoneBesideTheCell) {
  source->SetScene(test::synthetic_scene(12.0));
  const vtkNew<StageSource> nothing;
  EXPECT_FALSE(MembraneView(nothing).node_at(100.0, 100.0));
  view.add_to(window);
  window->Render();
  const auto node = view.node_at(320.0, 150.0);
  ASSERT_TRUE(node);
  const auto surface = source->GetScene().surface.shallow_copy();
  ASSERT_LT(*node, surface->GetNumberOfPoints());
  // Towards the camera, which looks along +z: on the near side of the cell.
  double bounds_um[6];
  surface->GetBounds(bounds_um);
  EXPECT_LT(surface->GetPoint(*node)[2], 0.5 * (bounds_um[4] + bounds_um[5]));
  EXPECT_FALSE(view.node_at(3.0, 3.0));
  view.mark_node(node);
  window->Render();
  view.mark_node(surface->GetNumberOfPoints());
  window->Render();
}

}  // namespace
}  // namespace pellucida
