#pragma once
#include <cstddef>
#include <vector>

#include "pellucida/core/Measurement.h"

namespace pellucida {

/// One point of a force curve. The interval's ends equal the force where no interval was given.
struct TracePoint {
  double time_s = 0.0;
  double indentation_um = 0.0;  ///< NaN where it was not measured
  double force_uN = 0.0;
  double lower_uN = 0.0;
  double upper_uN = 0.0;
};

/// What the charts show of a run of measurements, bounded however long it lasts: rows with a force, thinned to every
/// second one whenever a trace grows beyond `kMostPoints`.
class TraceHistory {
 public:
  static constexpr std::size_t kMostPoints = 4000;

  /// Rows without a force are left out. A step of time backwards (a recording started again) starts all afresh.
  void append(const Measurement& m);
  void clear();

  /// All rows over time.
  const std::vector<TracePoint>& over_time() const noexcept { return all_.points; }
  /// Rows since the needle last came into contact.
  const std::vector<TracePoint>& current_touch() const noexcept { return current_.points; }
  /// Rows of the touch before that.
  const std::vector<TracePoint>& previous_touch() const noexcept { return previous_; }

 private:
  struct Trace {
    std::vector<TracePoint> points;
    std::size_t every = 1;  // keeps one row in this many
    std::size_t offered = 0;
    void append(const TracePoint& point);
  };

  Trace all_;
  Trace current_;
  std::vector<TracePoint> previous_;
  CellState state_ = CellState::kNoCell;
};

}  // namespace pellucida
