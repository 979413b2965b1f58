#pragma once
#include "PunctureVerdict.h"
#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ShapeAudit.h"

namespace pellucida {

/// How deep the dimple's flanks lie within the resting outline, um: the mean over the contours' points 12 to 40 degrees
/// beside `contact`'s entry, seen from the centre, of both membranes where both are seen. Nothing the needle hides or a
/// tracker ties to its tip is in it. NaN where no contour shows flanks.
double flank_depth_um(const Observation& observation, const NeedleContact& contact);

/// What a frame in contact gives the verdict on a puncture.
PunctureVerdict::Sight sight_of(const Observation& observation, const NeedleContact& contact);

}  // namespace pellucida
