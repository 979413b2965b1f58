#pragma once
#include <optional>
#include <string>

#include "pellucida/haptics/LatencyHistogram.h"

namespace pellucida {

/// Lateness of a periodic thread as cyclictest saw it, us.
struct CyclictestFigures {
  LatencySummary lateness_us;
  std::string policy;  ///< "SCHED_FIFO 80", or what it ran with instead
};

/// The hand's loop beside the whole pipeline and the views, and cyclictest in turns with it under the same load.
struct HapticsFigures {
  LatencySummary lateness_us;
  LatencySummary compute_us;
  std::uint64_t missed_count = 0;
  std::string policy;                           ///< what the system granted the loop, one line
  std::optional<CyclictestFigures> cyclictest;  ///< nothing where the program isn't installed
  double pipeline_frames_per_s = 0.0;           ///< measured beside it
  double display_frames_per_s = 0.0;            ///< drawn beside it
};

/// Measures for `seconds` in all, loop and cyclictest in turns. Main thread only (it draws). Throws DeviceError where
/// nothing can be drawn, UsageError for less than 4 s.
HapticsFigures measure_haptics(double seconds);

/// cyclictest's histogram ("000012 000345" lines, us and count) as percentiles. Overflows count as its largest value.
LatencySummary summarize_cyclictest(const std::string& output);

}  // namespace pellucida
