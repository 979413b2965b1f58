#pragma once
#include <optional>

#include "pellucida/membrane/IndentedSolid.h"
#include "pellucida/membrane/MembraneGeometry.h"
#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {

/// The shipped solid's force on a needle opposite the holding pipette, for a cell of a profile's kind at rest a sphere
/// of a wall that doesn't stiffen: what the springs' force is replaced with. Allocates.
class SolidForce {
 public:
  /// Nothing where the profile has no solid, or the geometry is outside the range that the solid was fitted in.
  static std::optional<SolidForce> of(const CellProfile& profile, const MembraneGeometry& geometry);

  /// ln of the force at a depth above 0, uN, and its derivative by depth, 1/um.
  struct LogForce {
    double log_uN = 0.0, by_depth_per_um = 0.0;
  };
  LogForce at(double depth_um) const;

  /// How much of the force is the solid's, the rest (of its logarithm) being the springs': 1 where the needle is
  /// opposite the holder; 0 where the solid, which is of revolution and keeps its volume, says nothing, and at the
  /// profile's own geometry, where the springs with their terms are the solid computed for it.
  double share(const MembraneSetup& setup) const noexcept;

 private:
  SolidForce(const SolidParameters& parameters, double radius_um, double log_scale_uN, double away)
      : solid_(&IndentedSolid::shipped()),
        parameters_(parameters),
        radius_um_(radius_um),
        log_scale_uN_(log_scale_uN),
        away_(away) {}

  const IndentedSolid* solid_;
  SolidParameters parameters_;
  double radius_um_, log_scale_uN_;
  double away_;  // from the profile's own geometry: 0, at it, to 1
};

/// The `solid_force_ratio` with which the solid's force on the profile's own cell is the springs' at the puncture's
/// depth, where the modulus was set; 0 where that cell is outside the range that the solid was fitted in, or the
/// springs find no equilibrium there.
double solid_force_ratio(const CellProfile& profile);

}  // namespace pellucida
