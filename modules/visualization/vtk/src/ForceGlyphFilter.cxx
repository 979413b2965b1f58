#include "ForceGlyphFilter.h"

#include <vtkDoubleArray.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

// Of a 95 % interval.
constexpr double kHalfWidth_sigmas = 1.96;
// Bars end there, in parts of the full scale's arrow.
constexpr double kMostBarShare = 3.0;

std::vector<vtkIdType> outer_nodes(vtkPolyData* surface) {
  std::vector<vtkIdType> nodes;
  vtkDataArray* membrane = surface->GetPointData()->GetArray(array_name::kMembrane);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    if (!membrane || membrane->GetComponent(i, 0) == static_cast<int>(Membrane::kOuter)) nodes.push_back(i);
  }
  return nodes;
}

vtkDataArray* forces_of(vtkPolyData* surface) {
  vtkDataArray* forces = surface->GetPointData()->GetArray(array_name::kForce);
  return forces && forces->GetNumberOfComponents() == 3 ? forces : nullptr;
}

// A force that isn't finite counts as none.
double magnitude_of(vtkDataArray* forces, vtkIdType node, double force_uN[3]) {
  forces->GetTuple(node, force_uN);
  const double magnitude_uN = vtkMath::Norm(force_uN);
  return std::isfinite(magnitude_uN) ? magnitude_uN : 0.0;
}

template <class Array>
vtkSmartPointer<Array> new_array(const char* name, int components) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

}  // namespace

vtkStandardNewMacro(ForceGlyphFilter);

double node_force_quantile_uN(vtkPolyData* surface, double share) {
  vtkDataArray* forces = surface ? forces_of(surface) : nullptr;
  if (!forces) return 0.0;
  std::vector<double> magnitudes_uN;
  double force_uN[3];
  for (const vtkIdType node : outer_nodes(surface)) {
    const double magnitude_uN = magnitude_of(forces, node, force_uN);
    if (magnitude_uN > 0.0) magnitudes_uN.push_back(magnitude_uN);
  }
  if (magnitudes_uN.empty()) return 0.0;
  const auto at = magnitudes_uN.begin() + std::lround(share * static_cast<double>(magnitudes_uN.size() - 1));
  std::nth_element(magnitudes_uN.begin(), at, magnitudes_uN.end());
  return *at;
}

void ForceGlyphFilter::order_nodes(vtkPolyData* surface, const std::vector<vtkIdType>& outer) {
  const auto wanted = std::min(outer.size(), static_cast<std::size_t>(this->MaximumCount));
  const bool same = surface->GetNumberOfPoints() == ordered_point_count_ && outer == candidates_;
  if (same && ordered_for_ >= wanted) return;
  ordered_for_ = wanted;
  // Farthest-point order: each next node is the one farthest from all chosen before.
  std::vector<double> distance2_um2(outer.size(), std::numeric_limits<double>::max());
  order_.clear();
  candidates_ = outer;
  std::size_t next = 0;
  while (order_.size() < wanted) {
    order_.push_back(outer[next]);
    double p[3];
    double q[3];
    surface->GetPoint(outer[next], p);
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < outer.size(); ++i) {
      surface->GetPoint(outer[i], q);
      distance2_um2[i] = std::min(distance2_um2[i], vtkMath::Distance2BetweenPoints(p, q));
      if (distance2_um2[i] > distance2_um2[farthest]) farthest = i;
    }
    if (distance2_um2[farthest] <= 0.0) break;
    next = farthest;
  }
  ordered_point_count_ = surface->GetNumberOfPoints();
}

double ForceGlyphFilter::arrow_length_um(double magnitude_uN, double most_share) const {
  const double share = std::clamp(magnitude_uN / this->FullScaleUN, 0.0, most_share);
  return this->LongestArrowUm * (this->LogScale ? 0.5 * std::log10(1.0 + 99.0 * share) : share);
}

int ForceGlyphFilter::RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) {
  auto* surface = vtkPolyData::GetData(inputs[0]);
  auto* output = vtkPolyData::GetData(outputs);
  vtkDataArray* forces = forces_of(surface);
  if (!forces) return 1;
  const std::vector<vtkIdType> outer = outer_nodes(surface);
  if (outer.empty()) return 1;
  // The node pushed hardest comes first, whatever the density.
  double force_uN[3];
  vtkIdType strongest = outer.front();
  double strongest_uN = -1.0;
  double middle[3] = {0.0, 0.0, 0.0};
  double p[3];
  std::vector<vtkIdType> loaded;
  for (const vtkIdType node : outer) {
    const double magnitude_uN = magnitude_of(forces, node, force_uN);
    if (magnitude_uN > 0.0) loaded.push_back(node);
    if (magnitude_uN > strongest_uN) {
      strongest_uN = magnitude_uN;
      strongest = node;
    }
    surface->GetPoint(node, p);
    for (int k = 0; k < 3; ++k) middle[k] += p[k] / static_cast<double>(outer.size());
  }
  constexpr std::size_t kFew = 4;
  order_nodes(surface, kFew * loaded.size() < outer.size() ? loaded : outer);
  std::vector<vtkIdType> chosen{strongest};
  for (const vtkIdType node : order_) {
    if (static_cast<int>(chosen.size()) >= this->MaximumCount) break;
    if (node != strongest) chosen.push_back(node);
  }

  vtkNew<vtkPoints> points;
  auto kept_uN = new_array<vtkDoubleArray>(array_name::kForce, 3);
  auto magnitudes_uN = new_array<vtkDoubleArray>("magnitude_uN", 1);
  auto colors_uN = new_array<vtkDoubleArray>("color_uN", 1);
  auto bars_um = new_array<vtkDoubleArray>("bar_um", 2);
  vtkDataArray* sigmas = surface->GetPointData()->GetArray(array_name::kForceSigma);
  auto lengths_um = new_array<vtkDoubleArray>("arrow_length_um", 1);
  auto kinds = new_array<vtkIntArray>("arrow_kind", 1);
  for (const vtkIdType node : chosen) {
    const double magnitude_uN = magnitude_of(forces, node, force_uN);
    if (magnitude_uN <= 0.0 || magnitude_uN < this->ThresholdRatio * this->FullScaleUN) continue;
    surface->GetPoint(node, p);
    // An arrow that pushes inward would hide inside the cell: it ends at its node instead of starting there.
    const double outward[3] = {p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]};
    points->InsertNextPoint(p);
    kept_uN->InsertNextTuple(force_uN);
    magnitudes_uN->InsertNextValue(magnitude_uN);
    const double half_uN = sigmas ? kHalfWidth_sigmas * sigmas->GetComponent(node, 0) : 0.0;
    colors_uN->InsertNextValue(magnitude_uN < half_uN ? std::numeric_limits<double>::quiet_NaN() : magnitude_uN);
    bars_um->InsertNextTuple2(half_uN > 0.0 ? arrow_length_um(magnitude_uN - half_uN, kMostBarShare) : 0.0,
                              half_uN > 0.0 ? arrow_length_um(magnitude_uN + half_uN, kMostBarShare) : 0.0);
    lengths_um->InsertNextValue(arrow_length_um(magnitude_uN));
    kinds->InsertNextValue(vtkMath::Dot(force_uN, outward) < 0.0 ? 1 : 0);
  }
  output->SetPoints(points);
  for (vtkDataArray* array : {static_cast<vtkDataArray*>(kept_uN), static_cast<vtkDataArray*>(magnitudes_uN),
                              static_cast<vtkDataArray*>(colors_uN), static_cast<vtkDataArray*>(bars_um),
                              static_cast<vtkDataArray*>(lengths_um), static_cast<vtkDataArray*>(kinds)}) {
    output->GetPointData()->AddArray(array);
  }
  return 1;
}

}  // namespace pellucida
