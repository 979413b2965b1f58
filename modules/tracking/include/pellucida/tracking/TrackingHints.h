#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// What is known about one frame besides its pixels.
struct FrameHints {
  /// How far a manipulator moved the needle, by its own report, since the frame processed before, um in frame W. Held
  /// against what the film shows before it is believed, so that scale and axes may be off, and the film late by a
  /// frame: then a tip that seems to go back uncommanded in contact is misread, and one not seen is where it was sent.
  std::optional<Eigen::Vector2d> needle_motion_um;
};

/// The position of the cell according to the user. One of the two is enough.
struct CellHint {
  std::optional<Eigen::Vector2d> inside_um;  ///< a point inside the cell (a click)
  std::optional<Contour_um> outline_um;      ///< a rough closed outline of 3 points or more, in any orientation
};

/// What came of a person's hints before the last frame, in words; empty where there was none.
struct HintOutcomes {
  std::string cell, needle, holder;
};

}  // namespace pellucida
