#pragma once
#include <cstddef>
#include <limits>
#include <vector>

#include "pellucida/core/Measurement.h"

namespace pellucida {

/// One point of a force curve. The intervals' ends equal the force where no interval was given.
struct TracePoint {
  double time_s = 0.0;
  double indentation_um = 0.0;  ///< NaN where it was not measured
  double force_uN = 0.0;
  double lower_uN = 0.0;
  double upper_uN = 0.0;
  double picture_lower_uN = 0.0;  ///< of what the picture leaves open; the two above are the whole
  double picture_upper_uN = 0.0;
  double true_uN = std::numeric_limits<double>::quiet_NaN();  ///< of a virtual cell, where it is known
  bool after_gap = false;                                     ///< no line joins it to the point before
};

/// A moment marked on the time axis.
struct TraceMark {
  double time_s = 0.0;
  CellState state = CellState::kNoCell;  ///< what the cell turned into: contact, punctured or lost
};

/// The data of the charts for a run of measurements, bounded however long it lasts: rows with a force, thinned to every
/// second one whenever a trace grows beyond `kMostPoints`. Frames without a force leave a gap in the curve when the
/// points beside it are more than `kBridged_s` apart; thinning keeps the gap.
class TraceHistory {
 public:
  static constexpr std::size_t kMostPoints = 4000;
  static constexpr std::size_t kMostMarks = 100;
  static constexpr double kBridged_s = 0.5;

  /// Rows without a force are left out; one of a frame that was not measured also does not end a touch. A step of time
  /// backwards (a recording started again) starts all afresh. `true_force_uN`: NaN where nobody knows it.
  void append(const Measurement& m, double true_force_uN = std::numeric_limits<double>::quiet_NaN());
  void clear();

  /// All rows over time.
  const std::vector<TracePoint>& over_time() const noexcept { return all_.points; }
  /// When the cell came into contact, was punctured or lost; the newest `kMostMarks`.
  const std::vector<TraceMark>& marks() const noexcept { return marks_; }
  /// Rows in contact since the needle last touched the cell; a passing loss does not end a touch. Once a puncture is
  /// seen, without those in which the membrane was on its way back already.
  const std::vector<TracePoint>& current_touch() const noexcept { return current_.points; }
  /// Whether the newest row belongs to it.
  bool in_touch() const noexcept { return state_ == CellState::kContact && !current_.points.empty(); }
  /// Rows of the touch before that.
  const std::vector<TracePoint>& previous_touch() const noexcept { return previous_; }

 private:
  struct Trace {
    std::vector<TracePoint> points;
    std::size_t every = 1;  // keeps one row in this many
    std::size_t offered = 0;
    long last_frame = 0;  // of the newest point
    void append(TracePoint point, long frame);
  };

  Trace all_;
  Trace current_;
  std::vector<TracePoint> previous_;
  std::vector<TraceMark> marks_;
  CellState state_ = CellState::kNoCell;
};

}  // namespace pellucida
