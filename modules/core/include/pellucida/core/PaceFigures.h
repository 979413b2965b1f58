#pragma once

namespace pellucida {

/// How a recording is played: its time against the wall clock, from the first frame shown to the newest.
struct PaceFigures {
  double speed_ratio = 1.0;   ///< asked for: 1 = the recording's own speed
  double first_time_s = 0.0;  ///< of the recording
  double last_time_s = 0.0;
  double first_wall_s = 0.0;  ///< of the run's clock
  double last_wall_s = 0.0;
  double largest_lateness_s = 0.0;  ///< of a frame, after the moment it was due

  double recorded_s() const noexcept { return last_time_s - first_time_s; }
  double wall_s() const noexcept { return last_wall_s - first_wall_s; }
  /// Time taken over time due, less 1: 0.01 is 1 % too slow. 0 before the second frame.
  double error_ratio() const noexcept { return recorded_s() > 0.0 ? wall_s() * speed_ratio / recorded_s() - 1.0 : 0.0; }
};

}  // namespace pellucida
