#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "CellFollower.h"

namespace pellucida {

/// The holding pipette of the cell `cell` that passes at `place`, px, where a person pointed: one of `tools` (found
/// round the cell) or of the scene's, else whatever pair of straight edges runs there from the cell outwards. Nothing
/// where the place lies inside the cell, or no two edges can be followed.
std::optional<HolderFit> find_holder_at(const FrameInput& frame, const std::vector<FoundTool>& tools,
                                        const contour::Circle& cell, const Eigen::Vector2d& place);

}  // namespace pellucida
