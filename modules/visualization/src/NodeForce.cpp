#include "pellucida/visualization/NodeForce.h"

#include "pellucida/core/Words.h"

namespace pellucida {

std::string node_force_name(NodeForceKind kind) {
  switch (kind) {
    case NodeForceKind::kTools:
      return say("Needle and holding pipette");
    case NodeForceKind::kNeedle:
      return say("Needle");
    case NodeForceKind::kHolder:
      return say("Holding pipette");
    case NodeForceKind::kPressure:
      return say("Pressure");
    case NodeForceKind::kMembrane:
      break;
  }
  return say("Membrane resultant");
}

std::string node_force_explanation(NodeForceKind kind) {
  switch (kind) {
    case NodeForceKind::kTools:
      return say("What both tools do to the membrane: the needle pushes, the holding pipette holds against it.");
    case NodeForceKind::kNeedle:
      return say("What the needle does to the membrane under its tip. The bold arrow is the sum.");
    case NodeForceKind::kHolder:
      return say("What the holding pipette does to the membrane around its mouth. The bold arrow is the sum.");
    case NodeForceKind::kPressure:
      return say(
          "How the liquid inside pushes outwards on each node's share of the membrane. All together the arrows add up "
          "to zero.");
    case NodeForceKind::kMembrane:
      break;
  }
  return say(
      "How the stretched membrane pulls on its own points. It balances pressure and tools, so on a taut cell it points "
      "inwards although nothing pushes from outside. At rest it is zero: this is also its change from rest.");
}

std::string node_force_legend(NodeForceKind kind) {
  switch (kind) {
    case NodeForceKind::kTools:
      return say("Tools on membrane (µN)");
    case NodeForceKind::kNeedle:
      return say("Needle on membrane (µN)");
    case NodeForceKind::kHolder:
      return say("Holder on membrane (µN)");
    case NodeForceKind::kPressure:
      return say("Pressure on membrane (µN)");
    case NodeForceKind::kMembrane:
      break;
  }
  return say("Membrane resultant (µN)");
}

std::string coloring_name(SurfaceColoring coloring) {
  switch (coloring) {
    case SurfaceColoring::kPlain:
      return say("Plain");
    case SurfaceColoring::kTension:
      return say("Tension");
    case SurfaceColoring::kAreaStrain:
      return say("Area strain");
    case SurfaceColoring::kDisplacement:
      break;
  }
  return say("Displacement");
}

std::string coloring_explanation(SurfaceColoring coloring) {
  switch (coloring) {
    case SurfaceColoring::kPlain:
      return say("The membrane is clear, and shows what is behind it.");
    case SurfaceColoring::kTension:
      return say("Mean tension of the membrane, from the model: red is stretched, blue compressed, grey zero.");
    case SurfaceColoring::kAreaStrain:
      return say("Change of the membrane's area from rest, from the model: red is larger, blue smaller, grey zero.");
    case SurfaceColoring::kDisplacement:
      break;
  }
  return say("How far each place of the tracked surface is from where it was at rest.");
}

std::string coloring_legend(SurfaceColoring coloring) {
  switch (coloring) {
    case SurfaceColoring::kPlain:
      return {};
    case SurfaceColoring::kTension:
      return say("Tension (µN/µm)");
    case SurfaceColoring::kAreaStrain:
      return say("Area strain (%)");
    case SurfaceColoring::kDisplacement:
      break;
  }
  return say("Displacement (µm)");
}

bool is_signed(SurfaceColoring coloring) noexcept {
  return coloring == SurfaceColoring::kTension || coloring == SurfaceColoring::kAreaStrain;
}

}  // namespace pellucida
