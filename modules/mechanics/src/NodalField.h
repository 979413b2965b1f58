#pragma once
#include "pellucida/mechanics/ForceEstimate.h"
#include "pellucida/membrane/Indenter.h"

namespace pellucida {

/// Writes the forces on the nodes, their sigma (from the depth's along the tangent, and the relative errors) and the
/// tension of an estimate that has its rotation and errors. All are `scale` times the model's with the factors of its
/// geometry: the force's on what balances the tools, the pressure's, times `of_liquid_ratio`, on what balances the
/// liquid. The tension's sigma holds the force's own and what springs lack of a wall: its bending near the tools.
void fill_nodes(const Indenter& indenter, double scale, double of_liquid_ratio, bool contact, ForceEstimate& estimate);

/// Of the dampers of eq. (1), felt by a needle that moves along the push: what they dissipate at 1 um/s, uN s/um.
double damping_uN_s_per_um(const Indenter& indenter, double connector_damping_uN_s_per_um);

}  // namespace pellucida
