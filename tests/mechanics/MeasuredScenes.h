#pragma once
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/mechanics_vtk/MechanicsStep.h"
#include "pellucida/mechanics_vtk/NodalForces.h"

namespace pellucida::testing {

/// Two spheres (outer 52.5, inner 47.5 um) about (100, 80, 0) of rings about the needle's axis, as a reconstruction
/// gives them.
inline vtkSmartPointer<vtkPolyData> make_surface(const Eigen::Vector3d& axis, int meridian_count, int ring_count) {
  const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(axis);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> membrane;
  membrane->SetName(array_name::kMembrane);
  vtkNew<vtkDoubleArray> direction;
  direction->SetName("rest_direction");
  direction->SetNumberOfComponents(3);
  for (int m = 0; m < 2; ++m) {
    const double radius = m == 0 ? 52.5 : 47.5;
    const vtkIdType first = points->GetNumberOfPoints();
    const auto add = [&](double theta, double phi) {
      const Eigen::Vector3d d =
          std::cos(theta) * axis + std::sin(theta) * (std::cos(phi) * side + std::sin(phi) * Eigen::Vector3d::UnitZ());
      const Eigen::Vector3d p = Eigen::Vector3d(100, 80, 0) + radius * d;
      points->InsertNextPoint(p.data());
      direction->InsertNextTuple(d.data());
      membrane->InsertNextValue(m);
    };
    add(0.0, 0.0);
    for (int r = 1; r <= ring_count; ++r) {
      for (int k = 0; k < meridian_count; ++k) {
        add(std::numbers::pi * r / (ring_count + 1), 2.0 * std::numbers::pi * k / meridian_count);
      }
    }
    add(std::numbers::pi, 0.0);
    const vtkIdType last = points->GetNumberOfPoints() - 1;
    const auto node = [&](int r, int k) { return first + 1 + (r - 1) * meridian_count + k % meridian_count; };
    for (int k = 0; k < meridian_count; ++k) {
      const vtkIdType cap[3] = {first, node(1, k), node(1, k + 1)};
      cells->InsertNextCell(3, cap);
      for (int r = 1; r < ring_count; ++r) {
        const vtkIdType quad[4] = {node(r, k), node(r + 1, k), node(r + 1, k + 1), node(r, k + 1)};
        cells->InsertNextCell(4, quad);
      }
      const vtkIdType tail[3] = {node(ring_count, k), last, node(ring_count, k + 1)};
      cells->InsertNextCell(3, tail);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->AddArray(membrane);
  surface->GetPointData()->AddArray(direction);
  stamp(surface, 0.5, 15);
  return surface;
}

/// A cell as it was tracked, pushed by `depth_um` along `axis_rad`, with that surface.
inline Scene make_scene(double depth_um, double axis_rad, int meridian_count, int ring_count) {
  Observation o;
  o.time_s = 0.5;
  o.frame_index = 15;
  o.confidence = 1.0;
  o.state = depth_um > 0.0 ? CellState::kContact : CellState::kFree;
  o.center_um = {100.0, 80.0};
  o.rest_outer_radius_um = 52.5;
  o.rest_inner_radius_um = 47.5;
  o.outer.emplace();
  o.axis = {std::cos(axis_rad), std::sin(axis_rad)};
  o.needle = NeedlePose{};
  o.needle->confidence = 1.0;
  o.indentation_um = depth_um;
  o.indentation_sigma_um = 0.1;
  Scene scene;
  scene.observation = std::make_shared<const Observation>(o);
  scene.measurement = measurement_from(o);
  scene.surface =
      Frozen<vtkPolyData>(make_surface({std::cos(axis_rad), std::sin(axis_rad), 0.0}, meridian_count, ring_count));
  return scene;
}

/// Force and surface one after the other, as in the chain.
class MeasuringSteps {
 public:
  explicit MeasuringSteps(CellProfile profile) : mechanics_(std::move(profile)) {}
  expected<Scene, StepFailure> process(const Scene& scene) {
    auto measured = mechanics_.process(scene);
    if (!measured) return unexpected<StepFailure>(std::move(measured.error()));
    return nodal_forces_.add_to(std::move(measured->scene), measured->estimate);
  }

 private:
  MechanicsStep mechanics_;
  NodalForces nodal_forces_;
};

}  // namespace pellucida::testing
