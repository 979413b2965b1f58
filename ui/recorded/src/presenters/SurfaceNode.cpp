#include "presenters/SurfaceNode.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "pellucida/core/Words.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/visualization/Readout.h"
#include "presenters/SigmaInterval.h"

namespace pellucida {
namespace {

constexpr int kForceDecimals = 4;

double length_of(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

// A point's components; NaN where the array is missing or has other than three.
std::array<double, 3> vector_at(vtkPolyData* surface, const char* name, long number) {
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  std::array<double, 3> vector{SurfaceNode::kNone, SurfaceNode::kNone, SurfaceNode::kNone};
  if (array && array->GetNumberOfComponents() == 3) array->GetTuple(number, vector.data());
  return vector;
}

double number_at(vtkPolyData* surface, const char* name, long number) {
  vtkDataArray* array = surface->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array->GetComponent(number, 0) : SurfaceNode::kNone;
}

std::string with_unit(double value, int decimals, const char* unit) {
  return std::isfinite(value) ? readout::number(value, decimals) + " " + unit : readout::number(value, 0);
}

std::string membrane_name(const std::optional<Membrane>& membrane) {
  if (membrane == Membrane::kOuter) return say("outer membrane");
  if (membrane == Membrane::kInner) return say("inner membrane");
  if (membrane == Membrane::kOolemma) return say("oolemma");
  return say("unknown membrane");
}

std::string three(const std::array<double, 3>& v, int decimals, const char* unit) {
  if (!std::isfinite(length_of(v))) return readout::number(SurfaceNode::kNone, 0);
  return readout::number(v[0], decimals) + ", " + readout::number(v[1], decimals) + ", " +
         readout::number(v[2], decimals) + " " + unit;
}

}  // namespace

std::string axis_title(NodeArray array) {
  if (array == NodeArray::kTension) return say("Tension (µN/µm)");
  if (array == NodeArray::kDisplacement) return say("Displacement (µm)");
  return say("Force (µN)");
}

std::string name_of(NodeArray array) {
  const std::string title = axis_title(array);
  return title.substr(0, title.find(' '));
}

double value_of(const SurfaceNode& node, NodeArray array) noexcept {
  if (array == NodeArray::kTension) return node.tension_uN_per_um;
  if (array == NodeArray::kDisplacement) return node.displacement_um;
  return node.force_magnitude_uN;
}

double sigma_of(const SurfaceNode& node, NodeArray array) noexcept {
  if (array == NodeArray::kTension) return node.tension_sigma_uN_per_um;
  return array == NodeArray::kForce ? node.force_sigma_uN : SurfaceNode::kNone;
}

std::optional<SurfaceNode> surface_node(vtkPolyData* surface, long number) {
  if (!surface || number < 0 || number >= surface->GetNumberOfPoints()) return std::nullopt;
  SurfaceNode node;
  node.number = number;
  const double membrane = number_at(surface, array_name::kMembrane, number);
  if (membrane >= 0.0 && membrane <= 2.0) node.membrane = static_cast<Membrane>(static_cast<int>(membrane));
  surface->GetPoint(number, node.place_um.data());
  node.force_uN = vector_at(surface, array_name::kForce, number);
  node.force_magnitude_uN = length_of(node.force_uN);
  node.force_sigma_uN = number_at(surface, array_name::kForceSigma, number);
  node.tension_uN_per_um = number_at(surface, array_name::kTension, number);
  node.tension_sigma_uN_per_um = number_at(surface, array_name::kTensionSigma, number);
  node.displacement_um = length_of(vector_at(surface, array_name::kDisplacement, number));
  return node;
}

std::vector<NodeFact> node_facts(const SurfaceNode& node) {
  std::vector<NodeFact> facts;
  facts.push_back({say("Node"), std::to_string(node.number) + ", " + membrane_name(node.membrane)});
  facts.push_back({say("Place"), three(node.place_um, 1, "µm")});
  facts.push_back({say("Force"), with_unit(node.force_magnitude_uN, kForceDecimals, "µN")});
  const auto [low, high] = sigma_interval(node.force_magnitude_uN, node.force_sigma_uN);
  const bool known = std::isfinite(low) && std::isfinite(high);
  facts.push_back(
      {"95 %", known ? readout::number(low, kForceDecimals) + " \u2013 " + readout::number(high, kForceDecimals) + " µN"
                     : readout::number(SurfaceNode::kNone, 0)});
  facts.push_back({say("Sigma"), with_unit(node.force_sigma_uN, kForceDecimals, "µN")});
  facts.push_back({say("Along x, y, z"), three(node.force_uN, kForceDecimals, "µN")});
  const double tension_sigma = node.tension_sigma_uN_per_um;
  const std::string sigma = std::isfinite(tension_sigma) ? " ± " + readout::number(tension_sigma, kForceDecimals) : "";
  facts.push_back({say("Tension"), std::isfinite(node.tension_uN_per_um)
                                       ? readout::number(node.tension_uN_per_um, kForceDecimals) + sigma + " µN/µm"
                                       : with_unit(node.tension_uN_per_um, kForceDecimals, "µN/µm")});
  facts.push_back({say("Displacement"), with_unit(node.displacement_um, 2, "µm")});
  return facts;
}

}  // namespace pellucida
