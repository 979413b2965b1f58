#pragma once
#include <Eigen/Core>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// Where the needle meets the cell, from needle, centre and rest radius alone. Frame W, um.
struct NeedleContact {
  Eigen::Vector2d entry_um = Eigen::Vector2d::Zero();  ///< where the needle's line meets the resting outer circle
  double offset_um = 0.0;     ///< of the centre from the needle's line; > 0: the centre lies to the left of `direction`
                              ///< (towards (-dy, dx))
  double tip_depth_um = 0.0;  ///< of the tip past `entry_um`, along the needle; negative outside
};

/// The contact of the observation's needle. With the line passing the cell by, the entry is the point of the circle
/// nearest to the line. Precondition: `needle`, a rest radius above 0.
NeedleContact needle_contact(const Observation& observation);

/// How deep the dimple's flanks lie within the resting outline, um: the mean over the contours' points 12 to 40 degrees
/// beside `contact`'s entry, seen from the centre, of both membranes where both are seen. Nothing the needle hides or a
/// tracker ties to its tip is in it. NaN where no contour shows flanks.
double flank_depth_um(const Observation& observation, const NeedleContact& contact);

}  // namespace pellucida
