#include "NodeForceFilter.h"

#include <vtkDoubleArray.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

vtkDataArray* vectors_of(vtkPolyData* surface, const char* name) {
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 3 ? array : nullptr;
}

Eigen::Vector3d at(vtkDataArray* array, vtkIdType node) {
  Eigen::Vector3d value;
  array->GetTuple(node, value.data());
  return value;
}

// The arrays of a surface that the forces are made of.
struct ForcesOnNodes {
  vtkDataArray *membrane, *needle, *holder;

  bool hold(NodeForceKind kind) const {
    if (kind == NodeForceKind::kMembrane) return membrane;
    if (kind == NodeForceKind::kNeedle) return needle;
    if (kind == NodeForceKind::kHolder) return holder;
    return needle && holder && (kind == NodeForceKind::kTools || membrane);
  }
  Eigen::Vector3d tools_uN(vtkIdType node) const { return at(needle, node) + at(holder, node); }
  Eigen::Vector3d force_uN(NodeForceKind kind, vtkIdType node) const {
    switch (kind) {
      case NodeForceKind::kTools:
        return tools_uN(node);
      case NodeForceKind::kNeedle:
        return at(needle, node);
      case NodeForceKind::kHolder:
        return at(holder, node);
      case NodeForceKind::kPressure:
        return -(at(membrane, node) + tools_uN(node));
      case NodeForceKind::kMembrane:
        break;
    }
    return at(membrane, node);
  }
};

// Under the tools the deviation in proportion to the force, as it is beside them.
void take_proportion(const ForcesOnNodes& forces, vtkDataArray* force, vtkDoubleArray* sigma) {
  std::vector<double> ratios;
  std::vector<vtkIdType> touched;
  for (vtkIdType i = 0; i < sigma->GetNumberOfTuples(); ++i) {
    const double force_uN = at(force, i).norm();
    if (!forces.tools_uN(i).isZero(0.0)) {
      touched.push_back(i);
    } else if (force_uN > 0.0) {
      ratios.push_back(sigma->GetValue(i) / force_uN);
    }
  }
  if (ratios.empty()) return;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  for (const vtkIdType i : touched) sigma->SetValue(i, *middle * at(force, i).norm());
}

}  // namespace

vtkStandardNewMacro(NodeForceFilter);

void NodeForceFilter::SetKind(NodeForceKind kind) {
  if (kind == kind_) return;
  kind_ = kind;
  this->Modified();
}

int NodeForceFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* surface = vtkPolyData::GetData(inputs[0]);
  auto* output = vtkPolyData::GetData(outputs);
  output->SetPoints(surface->GetPoints());
  if (vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane)) {
    output->GetPointData()->AddArray(membrane);
  }
  const ForcesOnNodes forces{vectors_of(surface, array_name::kForce), vectors_of(surface, array_name::kNeedleForce),
                             vectors_of(surface, array_name::kHolderForce)};
  if (!forces.hold(kind_)) return 1;
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> chosen;
  chosen->SetName(array_name::kForce);
  chosen->SetNumberOfComponents(3);
  chosen->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i) chosen->SetTuple(i, forces.force_uN(kind_, i).data());
  output->GetPointData()->AddArray(chosen);

  vtkDataArray* given = surface->GetPointData()->GetArray(array_name::kForceSigma);
  if (!given || given->GetNumberOfComponents() != 1) return 1;
  vtkNew<vtkDoubleArray> sigma;
  sigma->DeepCopy(given);
  sigma->SetName(array_name::kForceSigma);
  if (kind_ == NodeForceKind::kPressure) take_proportion(forces, chosen, sigma);
  output->GetPointData()->AddArray(sigma);
  return 1;
}

}  // namespace pellucida
