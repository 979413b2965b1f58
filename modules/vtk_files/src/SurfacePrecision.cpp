#include "pellucida/vtk_files/SurfacePrecision.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

using namespace surface_precision;

double to_step(double value, double step) {
  // Without the sign of a zero, which costs a byte.
  return std::nearbyint(value / step) * step + 0.0;
}

double to_bits(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, kRelativeBits)), exponent - kRelativeBits);
}

// A copy of `array` as Float32, each number through `round(number, tuple)`.
template <class Round>
vtkSmartPointer<vtkFloatArray> rounded(vtkDataArray* array, Round round) {
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetName(array->GetName());
  const int components = array->GetNumberOfComponents();
  result->SetNumberOfComponents(components);
  result->SetNumberOfTuples(array->GetNumberOfTuples());
  float* target = result->GetPointer(0);
  const auto fill = [&](const auto* values) {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
      for (int j = 0; j < components; ++j) {
        const auto value = static_cast<double>(*values++);
        *target++ = static_cast<float>(std::isfinite(value) ? round(value, i) : value);
      }
    }
  };
  if (array->GetDataType() == VTK_DOUBLE) {
    fill(static_cast<const double*>(array->GetVoidPointer(0)));
  } else if (array->GetDataType() == VTK_FLOAT) {
    fill(static_cast<const float*>(array->GetVoidPointer(0)));
  } else {
    return nullptr;
  }
  return result;
}

template <class Round>
vtkSmartPointer<vtkFloatArray> round_array(vtkPointData* arrays, const char* name, Round round) {
  vtkDataArray* array = arrays->GetArray(name);
  vtkSmartPointer<vtkFloatArray> result = array ? rounded(array, round) : nullptr;
  if (result) arrays->AddArray(result);
  return result;
}

}  // namespace

vtkSmartPointer<vtkPolyData> narrowed_surface(vtkPolyData* surface) {
  auto narrow = vtkSmartPointer<vtkPolyData>::New();
  narrow->ShallowCopy(surface);
  const auto place = [](double value, vtkIdType) { return to_step(value, kPlaceStep_um); };
  if (vtkPoints* given = surface->GetPoints()) {
    if (const auto places = rounded(given->GetData(), place)) {
      vtkNew<vtkPoints> points;
      points->SetData(places);
      narrow->SetPoints(points);
    }
  }
  vtkPointData* arrays = narrow->GetPointData();
  round_array(arrays, array_name::kDisplacement, place);
  round_array(arrays, array_name::kRestDirection,
              [](double value, vtkIdType) { return to_step(value, kDirectionStep); });
  narrow_forces(narrow);
  return narrow;
}

void narrow_forces(vtkPolyData* surface) {
  vtkPointData* arrays = surface->GetPointData();
  const auto relative = [](double value, vtkIdType) { return to_bits(value); };
  round_array(arrays, array_name::kTension, relative);
  round_array(arrays, array_name::kTensionSigma, relative);
  round_array(arrays, array_name::kAreaStrain, relative);
  // The steps of the force follow from its deviations as they are kept, so that narrowing again changes nothing.
  const vtkSmartPointer<vtkFloatArray> sigma = round_array(arrays, array_name::kForceSigma, relative);
  const auto by_sigma = [&](double value, vtkIdType node) {
    const double sigma_uN =
        sigma && sigma->GetNumberOfComponents() == 1 && node < sigma->GetNumberOfTuples() ? sigma->GetValue(node) : 0.0;
    if (!(sigma_uN > 0.0) || !std::isfinite(sigma_uN)) return value;
    int exponent = 0;
    std::frexp(sigma_uN * kForceStepShare, &exponent);
    return to_step(value, std::ldexp(1.0, exponent - 1));
  };
  for (const char* name : {array_name::kForce, array_name::kNeedleForce, array_name::kHolderForce}) {
    round_array(arrays, name, by_sigma);
  }
}

}  // namespace pellucida
