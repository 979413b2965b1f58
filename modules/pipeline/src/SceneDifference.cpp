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
#include "pellucida/vtk_files/SurfacePrecision.h"

namespace pellucida {
namespace {

constexpr int kSpaceDimensions = 3;
constexpr const char* kRecordedForce = "recorded_force_uN";
constexpr const char* kForceDifference = "force_difference_uN";

vtkSmartPointer<vtkFloatArray> new_field(const char* name, int components, vtkIdType count) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

// An array of three components for each of `count` points as Float32, the array itself where it is that.
vtkSmartPointer<vtkFloatArray> floats_of(vtkPolyData* data, const char* name, vtkIdType count) {
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != kSpaceDimensions || array->GetNumberOfTuples() != count)
    return nullptr;
  if (auto* floats = vtkFloatArray::SafeDownCast(array)) return floats;
  auto copy = vtkSmartPointer<vtkFloatArray>::New();
  copy->DeepCopy(array);
  return copy;
}

// Adds the recorded array under another name.
void add_recorded(vtkPolyData* surface, vtkFloatArray* recorded, const char* name) {
  auto copy = vtkSmartPointer<vtkFloatArray>::New();
  copy->ShallowCopy(recorded);
  copy->SetName(name);
  surface->GetPointData()->AddArray(copy);
}

// Adds the difference, a missing side being 0; returns the largest magnitude.
double add_difference(vtkPolyData* surface, vtkFloatArray* now, vtkFloatArray* recorded, const char* name) {
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto difference = new_field(name, kSpaceDimensions, count);
  float* target = difference->GetPointer(0);
  const float* here = now ? now->GetPointer(0) : nullptr;
  const float* there = recorded ? recorded->GetPointer(0) : nullptr;
  double largest_squared = 0.0;
  for (vtkIdType node = 0; node < count; ++node) {
    double squared = 0.0;
    for (int i = 0; i < kSpaceDimensions; ++i) {
      const double change = (here ? static_cast<double>(*here++) : 0.0) - (there ? static_cast<double>(*there++) : 0.0);
      *target++ = static_cast<float>(change);
      squared += change * change;
    }
    largest_squared = std::max(largest_squared, squared);
  }
  surface->GetPointData()->AddArray(difference);
  return std::sqrt(largest_squared);
}

// What a session rounds is no difference: both are compared as they are written.
void compare_surfaces(const Scene& scene, const Scene& recorded, CommonFields& common) {
  auto surface = scene.surface.shallow_copy();
  if (!surface) return;
  surface = narrowed_surface(surface);
  auto before = recorded.surface.shallow_copy();
  const vtkIdType count = surface->GetNumberOfPoints();
  common.has_recorded =
      before && before->GetNumberOfPoints() == count && before->GetNumberOfPolys() == surface->GetNumberOfPolys();
  if (common.has_recorded) {
    before->SetPoints(nullptr);  // need not be narrowed
    before = narrowed_surface(before);
    const auto moved = floats_of(surface, array_name::kDisplacement, count);
    const auto moved_before = floats_of(before, array_name::kDisplacement, count);
    if (moved && moved_before) {
      add_recorded(surface, moved_before, "recorded_displacement_um");
      common.largest.displacement_um = add_difference(surface, moved, moved_before, "displacement_difference_um");
    }
    if (const auto force_before = floats_of(before, array_name::kForce, count)) {
      add_recorded(surface, force_before, kRecordedForce);
    }
  }
  common.surface = Frozen<vtkPolyData>(surface);
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

/// The contours of `scene` with their differences.
Frozen<vtkPolyData> compare_contours(const Scene& scene, const Scene& recorded, FieldDifferences& largest) {
  auto before = recorded.membranes.shallow_copy();
  auto membranes = scene.membranes.shallow_copy();
  if (!before || !membranes || membranes->GetNumberOfCells() == 0) return scene.membranes;
  vtkDataArray* kind = membranes->GetCellData()->GetArray(array_name::kMembrane);
  if (!kind) return scene.membranes;
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
  return Frozen<vtkPolyData>(membranes);
}

}  // namespace

CommonFields CommonFieldsMaker::make(const Scene& scene, const Scene& recorded) {
  CommonFields common;
  compare_surfaces(scene, recorded, common);
  const Frozen<vtkPolyData> membranes = compare_contours(scene, recorded, common.largest);
  common.surface_arrays = packer_.pack_arrays(common.surface);
  common.membranes = packer_.pack(SessionPart::kMembranes, membranes, scene.measurement);
  common.tools = packer_.pack(SessionPart::kTools, scene.tools, scene.measurement);
  return common;
}

vtkSmartPointer<vtkPolyData> variant_surface(const CommonFields& common, const SurfaceForces& forces,
                                             FieldDifferences& largest) {
  auto surface = common.surface.shallow_copy();
  if (!surface) return nullptr;
  if (forces.force_uN) {
    vtkPointData* arrays = surface->GetPointData();
    for (vtkDataArray* array : forces.arrays()) arrays->AddArray(array);
    narrow_forces(surface);
  }
  if (!common.has_recorded) return surface;
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto now = floats_of(surface, array_name::kForce, count);
  const auto before = floats_of(surface, kRecordedForce, count);
  if (now || before) largest.node_force_uN = add_difference(surface, now, before, kForceDifference);
  return surface;
}

}  // namespace pellucida
