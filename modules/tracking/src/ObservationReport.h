#pragma once
#include "CellFollower.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// What a follower knows of this frame, in um: contours that begin where the needle's axis crosses them, tools with
/// outlines, rest shape, indentation. Time and frame number are the caller's to fill in.
Observation report(const CellFollower& cell, double pixel_size_um);

/// The needle in um, with its outline.
NeedlePose needle_pose(const NeedleEstimate& needle, double pixel_size_um);

}  // namespace pellucida
