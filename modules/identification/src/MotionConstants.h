#pragma once
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// Mass m of a node and damping b of a connector for the model's time-stepped forms, eq. (2); the quasi-static force
/// uses neither. No reference curve holds them: they follow from criteria.
struct MotionConstants {
  /// The cell and its liquid, with the density of water, in equal parts on the nodes.
  double node_mass_kg = 0.0;
  /// The connector that oscillates quickest is damped critically: b = 2 sqrt(k m / 2), k = K2 A / L^2 at rest, m / 2
  /// the reduced mass of its two nodes. More would shorten the stable step of eq. (4), less would let it ring.
  double damping_uN_s_per_um = 0.0;
  /// Eq. (4) is stable at least below 2 / omega, omega^2 m the bound on the rest shape's largest stiffness: at a node
  /// twice the sum of its connectors' and its bond to a tool (Gershgorin's circles), and the liquid's kv |grad V|^2 /
  /// V0. Hinges add little; dampers shorten it.
  double stable_step_s = 0.0;
};

MotionConstants motion_constants(const CellProfile& profile);

}  // namespace pellucida
