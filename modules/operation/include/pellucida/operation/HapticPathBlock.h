#pragma once
#include <vtkPolyData.h>

#include <span>

#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/haptics/HapticRecord.h"

namespace pellucida {

/// Ticks of the hand as stored in the session: two polylines of one point per tick in the image's frame, um.
///
/// Cell array `path`: 0, where the hand wanted the tip; 1, where the manipulator reported it. Point arrays, the same
/// for both paths except the velocity:
///   | array               | components | unit | what                                                                |
///   | time_s              | 1          | s    | of the tick, in the session's time                                  |
///   | velocity_um_per_s   | 3          | um/s | along the path, from tick to tick                                   |
///   | hand_m              | 3          | m    | the hand itself, its own frame (x right, y up, z towards the person) |
///   | force_N             | 3          | N    | on the hand, its own frame                                          |
///   | guide_force_N       | 3          | N    | part of it: the fixtures                                            |
///   | contact_force_uN    | 3          | uN   | of the cell on the needle, as carried on to the tick                |
///   | contact_age_ms      | 1          | ms   | of the frame it rests on                                            |
///   | energy_margin_uJ    | 1          | uJ   | of the passivity observer                                           |
///   | limits, fixtures, buttons, hand_state, contact_state | 1 | | masks and states of HapticRecord |
///
/// `session_lag_s`: subtracted from a tick's own time. Empty without records.
Frozen<vtkPolyData> make_haptic_path_block(std::span<const HapticRecord> records, double session_lag_s);

}  // namespace pellucida
