#pragma once
#include "pellucida/haptics/CellStrength.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What a profile's kind of cell bears: force and indentation of its measured puncture, and the stiffness there for a
/// force that grows with the third power of depth, as the model's does.
CellStrength strength_of(const CellProfile& profile) noexcept;

}  // namespace pellucida
