#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "pellucida/core/Event.h"
#include "pellucida/haptics/LimitEvent.h"

namespace pellucida {

/// Turns limits that come and go at 1 kHz into rows of `events.csv` for people: one when a limit begins to act
/// ("depth: 46.1 um, limit 46 um"), one when it has not acted for `kQuiet_s` ("depth: over", or, where it came and went
/// meanwhile, "depth: over, acted 14 times in 3.2 s, at most 46.3 um"). One thread at a time.
class LimitDigest {
 public:
  static constexpr double kQuiet_s = 1.0;

  /// The next limit event, in the order of time.
  void add(const LimitEvent& limit);

  /// The rows known since the last call, at `now_s` on the clock of the limits. `session_lag_s`: what to take from
  /// their times.
  std::vector<Event> take(double now_s, double session_lag_s);

  /// The last rows: what is over counts as over, however short ago.
  std::vector<Event> finish(double session_lag_s);

 private:
  struct Stretch {
    bool reported = false;  // its beginning is a row, its end is not
    bool acting = false;
    double begin_s = 0.0;
    double end_s = 0.0;  // when it ceased to act, the last time
    long count = 0;      // how often it began
    double peak = 0.0;   // largest value by magnitude
  };

  std::array<Stretch, static_cast<std::size_t>(LimitKind::kCount)> stretches_{};
  std::vector<Event> waiting_;  // on the clock of the limits
};

}  // namespace pellucida
