#include "SceneDifference.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

constexpr int kSpaceDimensions = 3;

vtkSmartPointer<vtkFloatArray> new_field(const char* name, int components, vtkIdType count) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

vtkDataArray* point_array(vtkPolyData* data, const char* name) {
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == kSpaceDimensions ? array : nullptr;
}

/// The recorded array under another name, and the difference; returns the largest magnitude.
double add_field(vtkPolyData* surface, vtkDataArray* now, vtkDataArray* recorded, const char* recorded_name,
                 const char* difference_name) {
  const vtkIdType count = surface->GetNumberOfPoints();
  if (recorded) {
    auto before = vtkSmartPointer<vtkDataArray>::Take(recorded->NewInstance());
    before->ShallowCopy(recorded);
    before->SetName(recorded_name);
    surface->GetPointData()->AddArray(before);
  }
  const auto difference = new_field(difference_name, kSpaceDimensions, count);
  double largest = 0.0;
  for (vtkIdType node = 0; node < count; ++node) {
    Eigen::Vector3d here = Eigen::Vector3d::Zero(), there = Eigen::Vector3d::Zero();
    if (now) now->GetTuple(node, here.data());
    if (recorded) recorded->GetTuple(node, there.data());
    const Eigen::Vector3d change = here - there;
    difference->SetTuple(node, change.data());
    largest = std::max(largest, change.norm());
  }
  surface->GetPointData()->AddArray(difference);
  return largest;
}

void compare_surfaces(Scene& scene, const Scene& recorded, FieldDifferences& largest) {
  auto before = recorded.surface.shallow_copy();
  auto surface = scene.surface.shallow_copy();
  if (!before || !surface || before->GetNumberOfPoints() != surface->GetNumberOfPoints() ||
      before->GetNumberOfPolys() != surface->GetNumberOfPolys()) {
    return;
  }
  vtkDataArray* moved = point_array(surface, array_name::kDisplacement);
  vtkDataArray* moved_before = point_array(before, array_name::kDisplacement);
  if (moved && moved_before) {
    largest.displacement_um =
        add_field(surface, moved, moved_before, "recorded_displacement_um", "displacement_difference_um");
  }
  vtkDataArray* force = point_array(surface, array_name::kForce);
  vtkDataArray* force_before = point_array(before, array_name::kForce);
  if (force || force_before) {
    largest.node_force_uN = add_field(surface, force, force_before, "recorded_force_uN", "force_difference_uN");
  }
  scene.surface = Frozen<vtkPolyData>(surface);
}

/// The points of one membrane's polyline, closed; empty where it is not there.
Eigen::Matrix2Xd contour_of_membrane(vtkPolyData* membranes, int membrane) {
  vtkDataArray* kind = membranes->GetCellData()->GetArray(array_name::kMembrane);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; kind && cell < membranes->GetNumberOfCells(); ++cell) {
    if (static_cast<int>(kind->GetComponent(cell, 0)) != membrane) continue;
    membranes->GetCellPoints(cell, ids);
    Eigen::Matrix2Xd points_um(2, ids->GetNumberOfIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      double point[3];
      membranes->GetPoint(ids->GetId(i), point);
      points_um.col(i) << point[0], point[1];
    }
    return points_um;
  }
  return {};
}

/// The nearest place on a polyline, and how far outside of it the point lies (the contour has a positive area).
struct NearestPlace {
  Eigen::Vector2d place_um = Eigen::Vector2d::Zero();
  double outside_um = 0.0;
};
NearestPlace nearest_on(const Eigen::Matrix2Xd& line_um, const Eigen::Vector2d& point_um) {
  NearestPlace nearest;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i + 1 < line_um.cols(); ++i) {
    const Eigen::Vector2d start = line_um.col(i), along = line_um.col(i + 1) - start;
    const double share =
        along.squaredNorm() > 0.0 ? std::clamp((point_um - start).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
    const Eigen::Vector2d way = point_um - (start + share * along);
    if (way.squaredNorm() >= least) continue;
    least = way.squaredNorm();
    nearest.place_um = start + share * along;
    const double side = along.y() * way.x() - along.x() * way.y();
    nearest.outside_um = std::copysign(way.norm(), side);
    if (least == 0.0) nearest.outside_um = 0.0;
  }
  return nearest;
}

void compare_contours(Scene& scene, const Scene& recorded, FieldDifferences& largest) {
  auto before = recorded.membranes.shallow_copy();
  auto membranes = scene.membranes.shallow_copy();
  if (!before || !membranes || membranes->GetNumberOfCells() == 0) return;
  vtkDataArray* kind = membranes->GetCellData()->GetArray(array_name::kMembrane);
  if (!kind) return;
  const vtkIdType count = membranes->GetNumberOfPoints();
  const auto places = new_field("recorded_um", kSpaceDimensions, count);
  const auto distances = new_field("difference_um", 1, count);
  places->Fill(Measurement::kNotMeasured);
  distances->Fill(Measurement::kNotMeasured);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < membranes->GetNumberOfCells(); ++cell) {
    const auto line_um = contour_of_membrane(before, static_cast<int>(kind->GetComponent(cell, 0)));
    if (line_um.cols() < 2) continue;
    membranes->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i) {
      double point[3];
      membranes->GetPoint(ids->GetId(i), point);
      const Eigen::Vector2d point_um(point[0], point[1]);
      NearestPlace nearest{point_um, 0.0};
      // The same point, as where only the mechanics ran again, needs no search.
      if (i >= line_um.cols() || line_um.col(i) != point_um) nearest = nearest_on(line_um, point_um);
      places->SetTuple3(ids->GetId(i), nearest.place_um.x(), nearest.place_um.y(), 0.0);
      distances->SetTuple1(ids->GetId(i), nearest.outside_um);
      if (!(std::abs(nearest.outside_um) <= largest.contour_um)) largest.contour_um = std::abs(nearest.outside_um);
    }
  }
  membranes->GetPointData()->AddArray(places);
  membranes->GetPointData()->AddArray(distances);
  scene.membranes = Frozen<vtkPolyData>(membranes);
}

}  // namespace

FieldDifferences add_differences(Scene& scene, const Scene& recorded) {
  FieldDifferences largest;
  compare_surfaces(scene, recorded, largest);
  compare_contours(scene, recorded, largest);
  return largest;
}

}  // namespace pellucida
