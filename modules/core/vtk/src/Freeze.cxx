#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationInformationVectorKey.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pellucida/core_vtk/Frozen.h"

namespace pellucida {
namespace {

// VTK's own way to an array's ranges takes some 15 us a range, however short the array; a frame has some hundred.
struct Ranges {
  using Range = std::array<double, 2>;
  static constexpr Range kNone{VTK_DOUBLE_MAX, VTK_DOUBLE_MIN};
  explicit Ranges(int component_count) : components(static_cast<std::size_t>(component_count), kNone) {}
  std::vector<Range> components;
  Range squared_norm = kNone;
};

void widen(Ranges::Range& range, double value) noexcept {
  range[0] = std::min(range[0], value);
  range[1] = std::max(range[1], value);
}

// As VTK has them: NaN widens no range; the finite ones leave infinite numbers, and tuples with one, out.
template <class T>
void find_ranges(const T* values, vtkIdType tuple_count, Ranges& all, Ranges& finite) {
  const std::size_t component_count = all.components.size();
  for (vtkIdType tuple = 0; tuple < tuple_count; ++tuple) {
    double squares = 0.0;
    for (std::size_t c = 0; c < component_count; ++c) {
      const auto value = static_cast<double>(*values++);
      squares += value * value;
      if (std::isnan(value)) continue;
      widen(all.components[c], value);
      if (std::isfinite(value)) widen(finite.components[c], value);
    }
    if (std::isnan(squares)) continue;
    widen(all.squared_norm, squares);
    if (std::isfinite(squares)) widen(finite.squared_norm, squares);
  }
}

// Where VTK looks for a range before it computes one (`vtkDataArray::COMPONENT_RANGE`).
void keep(vtkInformation* information, const Ranges& ranges, vtkInformationInformationVectorKey* by_component,
          vtkInformationDoubleVectorKey* norm) {
  vtkNew<vtkInformationVector> components;
  components->SetNumberOfInformationObjects(static_cast<int>(ranges.components.size()));
  for (std::size_t c = 0; c < ranges.components.size(); ++c) {
    components->GetInformationObject(static_cast<int>(c))
        ->Set(vtkDataArray::COMPONENT_RANGE(), ranges.components[c].data(), 2);
  }
  information->Set(by_component, components);
  if (ranges.components.size() < 2) return;
  const double lengths[2] = {std::sqrt(ranges.squared_norm[0]), std::sqrt(ranges.squared_norm[1])};
  information->Set(norm, lengths, 2);
}

bool has_ranges(vtkInformation* information) {
  return information->Has(vtkDataArray::PER_COMPONENT()) && information->Has(vtkDataArray::PER_FINITE_COMPONENT());
}

template <class T>
bool keep_ranges(vtkDataArray* array) {
  auto* values = vtkAOSDataArrayTemplate<T>::SafeDownCast(array);
  if (!values || values->GetNumberOfTuples() == 0) return false;
  vtkInformation* information = values->GetInformation();
  if (has_ranges(information)) return true;
  Ranges all(values->GetNumberOfComponents()), finite(values->GetNumberOfComponents());
  find_ranges(values->GetPointer(0), values->GetNumberOfTuples(), all, finite);
  keep(information, all, vtkDataArray::PER_COMPONENT(), vtkDataArray::L2_NORM_RANGE());
  keep(information, finite, vtkDataArray::PER_FINITE_COMPONENT(), vtkDataArray::L2_NORM_FINITE_RANGE());
  return true;
}

// VTK makes an array's information and its ranges at the first question and keeps them: make them now, while there is
// one thread. VTK's XML writers change more than that: OwnArrays.h.
void fill_caches(vtkAbstractArray* array) {
  if (!array) return;
  array->GetInformation();
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers) return;
  if (keep_ranges<double>(numbers) || keep_ranges<float>(numbers) || keep_ranges<int>(numbers) ||
      keep_ranges<long long>(numbers)) {
    return;
  }
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
    if (poly->GetNumberOfCells() > 0 && poly->NeedToBuildCells()) poly->BuildCells();
  }
}

}  // namespace pellucida
