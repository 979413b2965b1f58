#pragma once
#include <functional>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/core_vtk/Frozen.h"
#include "pellucida/haptics/HapticRecord.h"
#include "pellucida/operation/HapticPathBlock.h"
#include "pellucida/operation/LimitDigest.h"

namespace pellucida {

/// What the 1 kHz loop did, as a session keeps it: limits as events (`LimitDigest`), ticks as blocks of a second.
/// Nothing is dropped while the disk is slower: blocks wait. One thread.
class HapticWriter {
 public:
  static constexpr std::size_t kBlockTicks = 1000;

  using WriteEvent = std::function<void(const Event&)>;
  /// A block and the time of its first tick, in the session's time; false: no room now, try again later.
  using WriteBlock = std::function<bool(const Frozen<vtkPolyData>&, double time_s)>;

  HapticWriter(WriteEvent write_event, WriteBlock write_block);

  // What the loop did, in the order of time, on the run's clock.
  void add(const LimitEvent& limit) { limits_.add(limit); }
  void add(const HapticRecord& tick) { ticks_.push_back(tick); }

  /// Writes what is ready at `now_s` on the run's clock, as far as there is room. `session_lag_s`: what to take from
  /// times of that clock.
  void flush(double now_s, double session_lag_s);
  /// The same with the last ticks, however few.
  void finish(double session_lag_s);

 private:
  struct Block {
    Frozen<vtkPolyData> paths;
    double time_s = 0.0;
  };
  void write(double session_lag_s, std::size_t least_ticks);

  WriteEvent write_event_;
  WriteBlock write_block_;
  LimitDigest limits_;
  std::vector<HapticRecord> ticks_;  // not yet in a block
  std::vector<Block> waiting_;       // not yet written, oldest first
};

}  // namespace pellucida
