#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "DashFilter.h"
#include "RibbonFilter.h"
#include "pellucida/core_vtk/SceneData.h"
#include "visualization/SyntheticScene.h"

namespace pellucida {
namespace {

double total_length_um(vtkPolyData* lines) {
  double length_um = 0.0;
  for (vtkIdType c = 0; c < lines->GetNumberOfCells(); ++c) {
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(c, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i) {
      double a[3];
      double b[3];
      lines->GetPoint(ids->GetId(i), a);
      lines->GetPoint(ids->GetId(i + 1), b);
      length_um += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  return length_um;
}

TEST(DashFilter, DrawsItsShareOfALine) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(101);
  for (int i = 0; i <= 100; ++i) lines->InsertCellPoint(points->InsertNextPoint(i, 0.0, 0.0));
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  vtkNew<DashFilter> dashes;
  dashes->SetInputData(line);
  dashes->SetDashUm(3.5);
  dashes->SetGapUm(1.5);
  dashes->Update();
  // Twenty dashes of 3.5 on a line of 100.
  EXPECT_EQ(dashes->GetOutput()->GetNumberOfCells(), 20);
  EXPECT_NEAR(total_length_um(dashes->GetOutput()), 70.0, 1e-4);
}

TEST(DashFilter, NothingInNothingOut) {
  vtkNew<vtkPolyData> nothing;
  vtkNew<DashFilter> dashes;
  dashes->SetInputData(nothing);
  dashes->Update();
  EXPECT_EQ(dashes->GetOutput()->GetNumberOfCells(), 0);
}

// Area of the ribbon's opaque part and of all of it, by the shoelace formula over its quads.
std::pair<double, double> ribbon_areas_um2(vtkPolyData* ribbon) {
  double solid_um2 = 0.0;
  double all_um2 = 0.0;
  auto* rgba = ribbon->GetPointData()->GetArray("color");
  for (vtkIdType c = 0; c < ribbon->GetNumberOfCells(); ++c) {
    vtkNew<vtkIdList> ids;
    ribbon->GetCellPoints(c, ids);
    double doubled_um2 = 0.0;
    bool solid = true;
    for (vtkIdType i = 0; i < 4; ++i) {
      double a[3];
      double b[3];
      ribbon->GetPoint(ids->GetId(i), a);
      ribbon->GetPoint(ids->GetId((i + 1) % 4), b);
      doubled_um2 += a[0] * b[1] - a[1] * b[0];
      solid = solid && rgba->GetComponent(ids->GetId(i), 3) == 255.0;
    }
    all_um2 += 0.5 * std::abs(doubled_um2);
    if (solid) solid_um2 += 0.5 * std::abs(doubled_um2);
  }
  return {solid_um2, all_um2};
}

TEST(RibbonFilter, AStraightLineCoversItsLengthTimesItsWidth) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({points->InsertNextPoint(0, 0, 0), points->InsertNextPoint(30, 40, 0)});
  vtkNew<vtkPolyData> line;
  line->SetPoints(points);
  line->SetLines(lines);
  vtkNew<RibbonFilter> ribbon;
  ribbon->SetInputData(line);
  ribbon->SetWidthUm(4.0);
  ribbon->SetRimUm(1.0);
  ribbon->Update();
  const auto [solid_um2, all_um2] = ribbon_areas_um2(ribbon->GetOutput());
  EXPECT_NEAR(solid_um2, 50.0 * 3.0, 1.6e-4);
  EXPECT_NEAR(all_um2, 50.0 * 5.0, 1e-3);
}

TEST(RibbonFilter, AClosedContourIsARingWithoutAGap) {
  const auto membranes = test::synthetic_scene(0.0).membranes.shallow_copy();
  vtkNew<RibbonFilter> ribbon;
  ribbon->SetInputData(membranes);
  ribbon->SetWidthUm(2.0);
  ribbon->SetRimUm(0.5);
  ribbon->SetColors({palette::kOuter, palette::kInner}, array_name::kMembrane);
  ribbon->Update();
  // Two rings, of 48 and 40 um.
  const double expected_um2 = 2.0 * EIGEN_PI * (48.0 + 40.0) * 2.5;
  EXPECT_NEAR(ribbon_areas_um2(ribbon->GetOutput()).second, expected_um2, 6e-5 * expected_um2);
  // Each in its own colour.
  auto* rgba = ribbon->GetOutput()->GetPointData()->GetArray("color");
  EXPECT_NEAR(rgba->GetComponent(0, 0), 255.0 * palette::kOuter.red, 0.5);
  EXPECT_NEAR(rgba->GetComponent(rgba->GetNumberOfTuples() - 1, 0), 255.0 * palette::kInner.red, 0.5);
}

TEST(RibbonFilter, NothingInNothingOut) {
  vtkNew<vtkPolyData> nothing;
  vtkNew<RibbonFilter> ribbon;
  ribbon->SetInputData(nothing);
  ribbon->Update();
  EXPECT_EQ(ribbon->GetOutput()->GetNumberOfCells(), 0);
}

}  // namespace
}  // namespace pellucida
