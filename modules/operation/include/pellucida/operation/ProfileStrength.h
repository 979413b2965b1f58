#pragma once
#include "pellucida/core/Measurement.h"
#include "pellucida/haptics/CellStrength.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What a profile's kind of cell bears: force and indentation of its measured puncture, and the largest stiffness till
/// then.
CellStrength strength_of(const CellProfile& profile) noexcept;

/// What the cell that is seen bears under the needle that is seen (`ExpectedPuncture`), though no more than twice its
/// kind's; its kind's where no cell was measured.
CellStrength strength_of(const CellProfile& profile, const Measurement& seen) noexcept;

}  // namespace pellucida
