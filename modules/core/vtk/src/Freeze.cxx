#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "pellucida/core_vtk/Frozen.h"

namespace pellucida {
namespace {

// VTK computes a range at the first question and keeps it: ask now, while there is one thread.
void compute_ranges(vtkFieldData* field) {
  for (int i = 0; field && i < field->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = field->GetArray(i);
    if (!array) continue;
    double range[2];
    for (int component = -1; component < array->GetNumberOfComponents(); ++component) array->GetRange(range, component);
  }
}

}  // namespace

void prepare_for_sharing(vtkDataObject* data) {
  compute_ranges(data->GetFieldData());
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set) return;
  compute_ranges(set->GetPointData());
  compute_ranges(set->GetCellData());
  set->ComputeBounds();
  double bounds[6];
  set->GetBounds(bounds);
  // Cell look-up tables are built lazily too.
  if (auto* poly = vtkPolyData::SafeDownCast(data); poly && poly->GetNumberOfCells() > 0) poly->BuildCells();
}

}  // namespace pellucida
