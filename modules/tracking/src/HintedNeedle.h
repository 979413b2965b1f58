#pragma once
#include <Eigen/Core>
#include <vector>

#include "CellFollower.h"

namespace pellucida {

/// Starts `needle` with its tip near `tip`, px, where a person pointed: along one of `tools` that passes there, else
/// along whatever straight shaft ends there. False when none can be followed; `needle` then holds nothing.
bool start_at_hint(NeedleTracker& needle, const FrameInput& frame, const std::vector<FoundTool>& tools,
                   const Eigen::Vector2d& tip);

}  // namespace pellucida
