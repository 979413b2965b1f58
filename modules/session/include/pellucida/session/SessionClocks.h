#pragma once
#include <optional>

#include "pellucida/core/ClockFit.h"
#include "pellucida/session/SessionInfo.h"

namespace pellucida {

/// The line between the clocks of source and run; nothing where the session states none.
std::optional<ClockFit> clock_fit_of(const SessionInfo& info);

}  // namespace pellucida
