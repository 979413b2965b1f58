#pragma once
#include <array>
#include <string>

namespace pellucida {

/// Which force on the nodes of the membrane the arrows show. On every node membrane, pressure and tools add up to zero;
/// at rest each of them is zero.
enum class NodeForceKind {
  kTools,     ///< of needle and holding pipette on the membrane
  kNeedle,    ///< of the needle on the membrane
  kHolder,    ///< of the holding pipette on the membrane
  kPressure,  ///< of the liquid inside on the membrane
  kMembrane,  ///< the membrane's own elastic resultant
};
inline constexpr std::array kNodeForceKinds{NodeForceKind::kTools, NodeForceKind::kNeedle, NodeForceKind::kHolder,
                                            NodeForceKind::kPressure, NodeForceKind::kMembrane};

/// As it is chosen: "Needle and holding pipette".
std::string node_force_name(NodeForceKind kind);
/// One or two sentences: what it is, and how to read it.
std::string node_force_explanation(NodeForceKind kind);
/// Title of its colour scale, with the unit.
std::string node_force_legend(NodeForceKind kind);

/// What the colour of the outer membrane shows.
enum class SurfaceColoring {
  kPlain,         ///< nothing
  kTension,       ///< the model's mean membrane tension, uN/um; below 0: compressed
  kAreaStrain,    ///< the model's change of area from rest, %; below 0: smaller
  kDisplacement,  ///< distance of the seen surface's nodes from their places at rest, um
};
inline constexpr std::array kSurfaceColorings{SurfaceColoring::kPlain, SurfaceColoring::kTension,
                                              SurfaceColoring::kAreaStrain, SurfaceColoring::kDisplacement};

std::string coloring_name(SurfaceColoring coloring);
std::string coloring_explanation(SurfaceColoring coloring);
/// Title of its colour scale, with the unit; empty for kPlain.
std::string coloring_legend(SurfaceColoring coloring);
/// Whether it has a sign, so that its colours part at zero.
bool is_signed(SurfaceColoring coloring) noexcept;

}  // namespace pellucida
