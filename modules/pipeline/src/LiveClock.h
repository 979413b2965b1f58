#pragma once
#include <atomic>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "pellucida/core/ClockFit.h"

namespace pellucida {

/// The clock of a run's source against the run's own, on which frames arrive and hand and injector are stamped. The
/// session's time is the source's.
class LiveClock {
 public:
  /// `live`: the source has a clock of its own, which may drift; a recording is delivered by the run's.
  explicit LiveClock(bool live) : live_(live) {}

  /// A frame of the source's time `source_s` arrived at `run_s`. The reader's thread.
  void add(double source_s, double run_s);
  /// The source's time begins anew. The reader's thread.
  void begin_anew();

  /// What to take from the run's time to get the session's, now; infinite before the first frame. Any thread.
  double lag_s() const noexcept { return lag_s_; }
  /// Other clocks less the session's: the run's, and the wall clock (s since 1970). `run_now_s`: the run's time now.
  std::map<std::string, double> offsets(double run_now_s) const;
  /// The key `clocks` of `session.json`; empty where nothing can be said of them.
  std::string json() const;

 private:
  const bool live_;
  std::atomic<double> lag_s_{std::numeric_limits<double>::infinity()};
  mutable std::mutex mutex_;
  ClockPairs pairs_;
  std::optional<ClockFit> fit_;
  double next_fit_s_ = 0.0;
};

}  // namespace pellucida
