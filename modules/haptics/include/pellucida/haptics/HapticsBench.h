#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "pellucida/haptics/LatencyHistogram.h"
#include "pellucida/haptics/RealTime.h"

namespace pellucida {

struct HapticsBenchOptions {
  double seconds = 10.0;       ///< above 0
  double frames_per_s = 30.0;  ///< of the writer of contact models, above 0
  double period_s = 1e-3;
  RealTimePolicy policy = RealTimePolicy::kIgnore;
  int priority = 80;
  bool lock_memory = true;
  std::string device = "Touch";  ///< whose limits the loop keeps
  /// Asked now and then; true ends the run early. May be empty.
  std::function<bool()> interrupted;
};

/// What a run of the 1 kHz loop showed.
struct HapticsFigures {
  LatencySummary lateness_us;  ///< from a deadline to the start of its turn
  LatencySummary compute_us;   ///< of a turn
  std::uint64_t missed = 0;    ///< deadlines that passed while a turn was still to come
  std::uint64_t ticks = 0;
  std::uint64_t records_dropped = 0;  ///< a drain that can't follow
  std::uint64_t contact_ticks = 0;    ///< in which a contact was felt: the run did what it should
  std::string policy;                 ///< what the system granted, one line
};

/// Runs the loop as it runs with a person: a scripted hand that goes into a cell, pushes sideways against the guide,
/// and out again, all fixtures of a plan on; a thread that publishes contact models at camera rate and the pipette's
/// state at 100 Hz; another that drains the records. Whatever else shall load the machine runs beside it. Throws
/// UsageError for options out of range or a device without force, DeviceError where the policy enforces what the system
/// refuses.
HapticsFigures measure_haptics(const HapticsBenchOptions& options);

}  // namespace pellucida
