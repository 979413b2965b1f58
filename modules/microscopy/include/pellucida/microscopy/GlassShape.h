#pragma once
#include "pellucida/core/Observation.h"
#include "pellucida/microscopy/Look.h"

namespace pellucida {

/// The needle's glass: at each place `back_um` behind the tip a round tube, cut off by the bevel. Lateral places are in
/// the image plane, to the left of the direction tip to shaft; the tip is at 0, 0.
struct NeedleShape {
  double tip_radius_um = 1.5, taper_deg = 3.0, shaft_radius_um = 6.0;
  Look::Needle look;

  /// Of a closed needle: a round tip, then a cone that eases into the shaft. Of others the cone alone. 0 before it.
  double outer_radius_um(double back_um) const noexcept;
  double lumen_radius_um(double back_um) const noexcept;
  /// Where the tube's middle lies: beside the tip for a bevelled needle, whose tip is on its flank.
  double middle_um() const noexcept;
  /// How far a place lies inside the bevel's cut, um; below 0 cut away. Infinite for other ends.
  double inside_cut_um(double back_um, double lateral_um) const noexcept;
  /// Lateral reach of the spike at `back_um`: from the tip's flank on, to twice this radius.
  double spike_radius_um(double back_um) const noexcept;
  /// Lateral places of the glass's edges, low and high; equal where there is none.
  std::pair<double, double> span_um(double back_um) const noexcept;
};

/// The holding pipette's glass: a tube with a rounded rim, the mouth at `back_um` = 0, bent in the image plane.
struct HolderShape {
  double outer_radius_um = 22.5, wall_um = 10.0, bend_per_um = 0.0;

  /// Half the wall's thickness: the rim is a torus of this radius.
  double rim_radius_um() const noexcept { return wall_um / 2; }
  double ring_radius_um() const noexcept { return outer_radius_um - wall_um / 2; }
  /// Half the wall `back_um` behind the mouth's foremost point.
  double half_wall_um(double back_um) const noexcept;
  /// Where the tube's middle lies.
  double middle_um(double back_um) const noexcept;
};

}  // namespace pellucida
