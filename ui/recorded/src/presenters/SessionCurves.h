#pragma once
#include <cstddef>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "presenters/RecordedSession.h"

namespace pellucida {

/// The contact force of the whole session over time with its 95 % interval and, in it, what the picture leaves open;
/// contact, puncture and loss marked. Rows
/// without a force for more than half a second are a gap, as in the live chart.
CurveChartData force_over_time(const RecordedSession& session);

/// The contact force over the indentation: all touches of the session in grey, the one that `step` belongs to (or the
/// last before it) on top with its interval: loading up to its greatest depth, then unloading, dashed and without.
CurveChartData force_over_indentation(const RecordedSession& session, std::size_t step);

/// The step at which a touch is deepest, where the needle comes back by 2 um or more afterwards; else the number of
/// steps.
std::size_t turning_step(const RecordedSession& session, std::size_t touch);

/// Number of the touch that each step belongs to, as `touch_of` counts.
std::vector<std::size_t> touches_of(const RecordedSession& session);

/// Number of the touch that `step` belongs to, or the last before it; 0 before the first one. A passing loss and frames
/// that were not measured don't end a touch.
std::size_t touch_of(const RecordedSession& session, std::size_t step);

}  // namespace pellucida
