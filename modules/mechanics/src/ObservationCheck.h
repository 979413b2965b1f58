#pragma once
#include <string>

#include "pellucida/core/Observation.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// Whether a frame shows a cell at all, tracked now.
bool has_cell(const Observation& observation) noexcept;

/// Why no cell of `profile` can be measured in this frame, one line; empty where it can.
std::string why_not_measured(const Observation& observation, const CellProfile& profile);

}  // namespace pellucida
