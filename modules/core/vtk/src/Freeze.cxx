#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "pellucida/core_vtk/Frozen.h"

namespace pellucida {
namespace {

// VTK makes an array's information and its ranges at the first question and keeps them: ask now, while there is one
// thread. VTK's XML writers change more than that: OwnArrays.h.
void fill_caches(vtkAbstractArray* array) {
  if (!array) return;
  array->GetInformation();
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers) return;
  double range[2];
  for (int component = -1; component < numbers->GetNumberOfComponents(); ++component) {
    numbers->GetRange(range, component);
    numbers->GetFiniteRange(range, component);
  }
}

void fill_caches(vtkFieldData* field) {
  for (int i = 0; field && i < field->GetNumberOfArrays(); ++i) fill_caches(field->GetAbstractArray(i));
}

void fill_caches(vtkCellArray* cells) {
  if (!cells) return;
  fill_caches(cells->GetOffsetsArray());
  fill_caches(cells->GetConnectivityArray());
}

}  // namespace

void prepare_for_sharing(vtkDataObject* data) {
  fill_caches(data->GetFieldData());
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set) return;
  fill_caches(set->GetPointData());
  fill_caches(set->GetCellData());
  set->ComputeBounds();
  double bounds[6];
  set->GetBounds(bounds);
  if (auto* points = vtkPointSet::SafeDownCast(data); points && points->GetPoints()) {
    fill_caches(points->GetPoints()->GetData());
  }
  if (auto* poly = vtkPolyData::SafeDownCast(data)) {
    for (vtkCellArray* cells : {poly->GetVerts(), poly->GetLines(), poly->GetPolys(), poly->GetStrips()}) {
      fill_caches(cells);
    }
    // Cell look-up tables are built lazily too.
    if (poly->GetNumberOfCells() > 0) poly->BuildCells();
  }
}

}  // namespace pellucida
