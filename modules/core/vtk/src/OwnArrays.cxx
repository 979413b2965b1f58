#include "pellucida/core_vtk/OwnArrays.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace pellucida {
namespace {

vtkSmartPointer<vtkAbstractArray> own_array(vtkAbstractArray* array) {
  auto own = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  auto* numbers = vtkDataArray::SafeDownCast(own);
  if (numbers) {
    numbers->ShallowCopy(vtkDataArray::SafeDownCast(array));
  } else {
    own->DeepCopy(array);
  }
  own->SetName(array->GetName());
  return own;
}

void own_arrays(vtkFieldData* field) {
  for (int i = 0; field && i < field->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = field->GetAbstractArray(i);
    // An array of the same name takes the other's place.
    if (array->GetName()) field->AddArray(own_array(array));
  }
}

vtkSmartPointer<vtkCellArray> own_cells(vtkCellArray* cells) {
  auto own = vtkSmartPointer<vtkCellArray>::New();
  const auto offsets = own_array(cells->GetOffsetsArray()), connectivity = own_array(cells->GetConnectivityArray());
  own->SetData(vtkDataArray::SafeDownCast(offsets), vtkDataArray::SafeDownCast(connectivity));
  return own;
}

}  // namespace

void give_own_arrays(vtkDataObject* copy) {
  own_arrays(copy->GetFieldData());
  auto* set = vtkDataSet::SafeDownCast(copy);
  if (!set) return;
  own_arrays(set->GetPointData());
  own_arrays(set->GetCellData());
  if (auto* points = vtkPointSet::SafeDownCast(copy); points && points->GetPoints()) {
    const auto own = own_array(points->GetPoints()->GetData());
    vtkNew<vtkPoints> places;
    places->SetData(vtkDataArray::SafeDownCast(own));
    points->SetPoints(places);
  }
  if (auto* poly = vtkPolyData::SafeDownCast(copy)) {
    if (poly->GetNumberOfVerts() > 0) poly->SetVerts(own_cells(poly->GetVerts()));
    if (poly->GetNumberOfLines() > 0) poly->SetLines(own_cells(poly->GetLines()));
    if (poly->GetNumberOfPolys() > 0) poly->SetPolys(own_cells(poly->GetPolys()));
    if (poly->GetNumberOfStrips() > 0) poly->SetStrips(own_cells(poly->GetStrips()));
  }
}

}  // namespace pellucida
