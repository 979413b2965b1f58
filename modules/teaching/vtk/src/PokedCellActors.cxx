#include "PokedCellActors.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <numbers>

#include "ToolShapes.h"

namespace pellucida {
namespace {

constexpr double kTaper_rad = 3.0 * std::numbers::pi / 180.0;
constexpr double kCone_um = 120.0;
constexpr double kShaft_um = 400.0;
constexpr double kHolderLength_um = 90.0;
// The lip's middle, on which the cell bears, is at five sixths of the pipette's outer radius.
constexpr double kOuterOverRing = 1.2;

std::vector<ProfilePoint> poking_needle(double tip_radius_um) {
  const double shaft_um = tip_radius_um + kCone_um * std::tan(kTaper_rad);
  return {{0.0, 0.0},
          {0.1 * tip_radius_um, 0.7 * tip_radius_um},
          {0.5 * tip_radius_um, tip_radius_um},
          {kCone_um, shaft_um},
          {kShaft_um, shaft_um}};
}

void set_actor_color(vtkActor* actor, const Color& c) {
  actor->GetProperty()->SetColor(c.red, c.green, c.blue);
}

}  // namespace

void PokedCellActors::build(vtkRenderer* renderer) {
  surface->SetPoints(points);
  springs->SetPoints(points);
  pulls_uN->SetName("pull_uN");

  spring_mapper->SetInputData(springs);
  spring_mapper->SetLookupTable(pull_colors);
  spring_mapper->UseLookupTableScalarRangeOn();
  spring_mapper->SetScalarModeToUseCellData();
  spring_actor->SetMapper(spring_mapper);
  spring_actor->GetProperty()->LightingOff();
  spring_actor->PickableOff();
  spring_actor->VisibilityOff();
  renderer->AddActor(spring_actor);
  arrows.build(renderer);
  build_field(renderer);

  // Clear bodies come after solid ones, the cell's skin before the glass.
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  wall.mapper->SetInputConnection(normals->GetOutputPort());
  wall.mapper->ScalarVisibilityOff();
  // The skin lies behind the connectors that run along it.
  wall.mapper->SetResolveCoincidentTopologyToPolygonOffset();
  wall.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 1.0);
  wall.build(renderer, current_theme().cell, kWallOpacity, false);
  holder.build(renderer, current_theme().glass, 0.75);
  needle.build(renderer, current_theme().glass, 0.80);
  for (auto& side : needle.sides) side->SetUserTransform(needle_pose);
}

void PokedCellActors::build_field(vtkRenderer* renderer) {
  field_uN->SetName("field_uN");
  field_uN->SetNumberOfComponents(3);
  field->SetPoints(points);
  field->GetPointData()->SetVectors(field_uN);
  field_arrow->SetShaftRadius(0.05);
  field_arrow->SetTipRadius(0.14);
  field_arrow->SetTipLength(0.36);
  field_mapper->SetInputData(field);
  field_mapper->SetSourceConnection(field_arrow->GetOutputPort());
  field_mapper->SetOrientationArray("field_uN");
  field_mapper->SetOrientationModeToDirection();
  field_mapper->SetScaleArray("field_uN");
  field_mapper->SetScaleModeToScaleByMagnitude();
  field_mapper->SetScalarModeToUsePointFieldData();
  field_mapper->SelectColorArray("field_uN");
  field_colors->SetVectorModeToMagnitude();
  field_mapper->SetLookupTable(field_colors);
  field_mapper->UseLookupTableScalarRangeOn();
  field_actor->SetMapper(field_mapper);
  field_actor->GetProperty()->SetAmbient(0.45);
  field_actor->GetProperty()->SetDiffuse(0.65);
  field_actor->PickableOff();
  field_actor->VisibilityOff();
  renderer->AddActor(field_actor);
}

void PokedCellActors::scale_field(double longest_um, double full_uN) {
  field_mapper->SetScaleFactor(longest_um / full_uN);
  field_colors->SetTableRange(0.0, full_uN);
}

void PokedCellActors::set_mesh(std::shared_ptr<const CellMesh> next) {
  mesh = std::move(next);
  vtkNew<vtkCellArray> triangles;
  for (Eigen::Index t = 0; t < mesh->triangles.cols(); ++t) {
    triangles->InsertNextCell({mesh->triangles(0, t), mesh->triangles(1, t), mesh->triangles(2, t)});
  }
  surface->SetPolys(triangles);
  vtkNew<vtkCellArray> lines;
  for (const auto& [i, j] : mesh->pairs) lines->InsertNextCell({i, j});
  springs->SetLines(lines);
  pulls_uN->SetNumberOfTuples(static_cast<vtkIdType>(mesh->pairs.size()));
  springs->GetCellData()->SetScalars(pulls_uN);

  // Shapes are made along x; the needle lies along the push, the holding pipette on the other side.
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero(), along = Eigen::Vector2d::UnitX();
  needle.mapper->SetInputData(revolve_profile(poking_needle(mesh->tip_radius_um), origin, along));
  HolderPose pose;
  pose.outer_radius_um = kOuterOverRing * mesh->holder_ring_um;
  holder.mapper->SetInputData(revolve_profile(holder_profile(pose, kHolderLength_um), origin, along));
  vtkNew<vtkTransform> held;
  const double mouth_um =
      std::sqrt(mesh->mid_radius_um * mesh->mid_radius_um - mesh->holder_ring_um * mesh->holder_ring_um);
  held->Translate(0.0, 0.0, -mouth_um - 0.5 * mesh->thickness_um);
  held->RotateY(90.0);
  for (auto& side : holder.sides) side->SetUserTransform(held);
}

void PokedCellActors::set_theme(const ThemeColors& theme, double spring_width_px) {
  for (auto& side : wall.sides) set_actor_color(side, theme.cell);
  for (ClearWall* glass : {&needle, &holder}) {
    for (auto& side : glass->sides) set_actor_color(side, theme.glass);
  }
  fill_lookup_table(field_colors, ColorMapKind::kForce);
  spring_actor->GetProperty()->SetLineWidth(static_cast<float>(spring_width_px));
}

}  // namespace pellucida
