#include "NodePick.h"

#include <vtkCellLocator.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>

namespace pellucida {
namespace {

std::array<double, 3> world_at(vtkRenderer* renderer, double x_px, double y_px, double depth) {
  const int* origin = renderer->GetOrigin();
  renderer->SetDisplayPoint(origin[0] + x_px, origin[1] + y_px, depth);
  renderer->DisplayToWorld();
  const double* place = renderer->GetWorldPoint();
  return {place[0] / place[3], place[1] / place[3], place[2] / place[3]};
}

}  // namespace

std::optional<long> pick_node(vtkRenderer* renderer, double x_px, double y_px, vtkPolyData* surface) {
  if (!surface || surface->GetNumberOfCells() == 0) return std::nullopt;
  // A copy of the shell: a locator asks the data for cells, and data in use elsewhere stay untouched.
  vtkNew<vtkPolyData> own;
  own->ShallowCopy(surface);
  vtkNew<vtkCellLocator> cells;
  cells->SetDataSet(own);
  cells->BuildLocator();
  const auto near = world_at(renderer, x_px, y_px, 0.0), far = world_at(renderer, x_px, y_px, 1.0);
  double share = 0.0, parametric[3];
  std::array<double, 3> hit{};
  int sub = 0;
  vtkIdType cell = -1;
  vtkNew<vtkGenericCell> found;
  if (!cells->IntersectWithLine(near.data(), far.data(), 1e-6, share, hit.data(), parametric, sub, cell, found)) {
    return std::nullopt;
  }
  std::optional<long> nearest;
  double least_um2 = 0.0;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i) {
    const vtkIdType node = found->GetPointId(i);
    const double distance_um2 = vtkMath::Distance2BetweenPoints(hit.data(), own->GetPoint(node));
    if (nearest && distance_um2 >= least_um2) continue;
    nearest = static_cast<long>(node);
    least_um2 = distance_um2;
  }
  return nearest;
}

}  // namespace pellucida
