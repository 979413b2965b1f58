#include "MembraneHistory.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "CellSpans.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

// Area of a polygon, as a fan of triangles.
double area_of(const Corners& corners) {
  double area = 0.0;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    area += 0.5 * (corners[k - 1] - corners[0]).cross(corners[k] - corners[0]).norm();
  }
  return area;
}

void keep_larger(double& largest, double value) noexcept {
  if (!(value <= largest) && !std::isnan(value)) largest = value;
}

}  // namespace

MembraneState membrane_state(vtkPolyData* surface) {
  MembraneState state;
  vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
  vtkDataArray* displacement = surface->GetPointData()->GetArray(array_name::kDisplacement);
  vtkDataArray* tension = surface->GetPointData()->GetArray(array_name::kTension);
  if (!membrane || !displacement || displacement->GetNumberOfComponents() != 3) return state;

  double area_um2 = 0.0, rest_um2 = 0.0, tension_sum = 0.0;
  Corners now, rest;
  vtkCellArray* cells = surface->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    cells->GetCellAtId(c, count, nodes);
    if (count < 3 || membrane->GetComponent(nodes[0], 0) != static_cast<double>(Membrane::kOuter)) {
      continue;
    }
    now.clear();
    rest.clear();
    double tension_here = 0.0;
    for (vtkIdType k = 0; k < count; ++k) {
      Eigen::Vector3d point, way;
      surface->GetPoint(nodes[k], point.data());
      displacement->GetTuple(nodes[k], way.data());
      now.push_back(point);
      rest.emplace_back(point - way);
      if (!tension) continue;
      const double value = tension->GetComponent(nodes[k], 0);
      tension_here += value / static_cast<double>(count);
      keep_larger(state.largest_tension_uN_per_um, value);
    }
    const double here_um2 = area_of(now);
    area_um2 += here_um2;
    rest_um2 += area_of(rest);
    tension_sum += tension_here * here_um2;
  }
  if (rest_um2 <= 0.0) return MembraneState{};
  state.area_strain_percent = 100.0 * (area_um2 / rest_um2 - 1.0);
  if (tension && area_um2 > 0.0) state.mean_tension_uN_per_um = tension_sum / area_um2;
  return state;
}

std::vector<MembraneState> membrane_history(const SessionReader& session, const SessionProgress& progress,
                                            std::vector<std::string>& unread) {
  std::vector<std::size_t> steps;
  for (std::size_t i = 0; i < session.steps().size(); ++i) {
    if (is_touching(session.measurements()[i]) && session.steps()[i].has(SessionPart::kSurface)) steps.push_back(i);
  }
  std::vector<MembraneState> history(session.steps().size());
  std::size_t bad_count = 0;
  std::string first;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    try {
      history[steps[k]] = membrane_state(session.load(steps[k], SessionPart::kSurface).shallow_copy());
    } catch (const InputError& error) {
      if (++bad_count == 1) first = error.what();
    }
    if (progress) progress(k + 1, steps.size());
  }
  if (bad_count > 0) {
    unread.push_back(std::to_string(bad_count) +
                     " surface(s) can't be read and are missing in strain and tension, the "
                     "first: " +
                     first);
  }
  return history;
}

}  // namespace pellucida
