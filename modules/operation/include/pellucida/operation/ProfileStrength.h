#pragma once
#include "pellucida/haptics/CellStrength.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What a profile's kind of cell bears: force and indentation of its measured puncture, and the stiffness there for a
/// force that grows with the third power of depth, as the model's does. `scale_ratio` (> 0): the stiffness of this cell
/// over its kind's. The force at the puncture is the kind's however stiff a cell is (as in `puncture_probability`), so
/// that a stiffer one bears it at a smaller depth.
CellStrength strength_of(const CellProfile& profile, double scale_ratio = 1.0) noexcept;

}  // namespace pellucida
