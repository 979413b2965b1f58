#pragma once
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"

class vtkPolyData;

namespace pellucida {

/// What a recorded surface says of one of its nodes; NaN where the surface lacks the array.
struct SurfaceNode {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  long number = 0;  ///< of the point, from 0
  std::optional<Membrane> membrane;
  std::array<double, 3> place_um{kNone, kNone, kNone};  ///< frame W
  std::array<double, 3> force_uN{kNone, kNone, kNone};
  double force_magnitude_uN = kNone;
  double force_sigma_uN = kNone;  ///< standard deviation of the magnitude
  double tension_uN_per_um = kNone;
  double tension_sigma_uN_per_um = kNone;  ///< its standard deviation
  double displacement_um = kNone;          ///< its length
};

/// The arrays of a node that can be drawn.
enum class NodeArray { kForce, kTension, kDisplacement };
inline constexpr std::array kNodeArrays{NodeArray::kForce, NodeArray::kTension, NodeArray::kDisplacement};
/// "Force (µN)": as an axis is titled.
std::string axis_title(NodeArray array);
/// "Force": as a list names it.
std::string name_of(NodeArray array);
double value_of(const SurfaceNode& node, NodeArray array) noexcept;
/// Its standard deviation; NaN where it has none.
double sigma_of(const SurfaceNode& node, NodeArray array) noexcept;

/// Node `number` of `surface`; nothing where there is no surface, or no such node.
std::optional<SurfaceNode> surface_node(vtkPolyData* surface, long number);

/// A name and its value as text, with unit.
struct NodeFact {
  std::string name;
  std::string value;
};
/// What the panel says of a node: place, force with its 95 % interval, tension, displacement. What the session doesn't
/// hold is a dash.
std::vector<NodeFact> node_facts(const SurfaceNode& node);

}  // namespace pellucida
