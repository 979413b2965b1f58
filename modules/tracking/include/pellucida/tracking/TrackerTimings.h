#pragma once
#include <chrono>

namespace pellucida {

/// Time spent on the parts of one frame, us. A part that did not run is 0.
struct TrackerTimings {
  double needle_us = 0.0;     ///< needle and, while it is missing, the search for it
  double rigid_us = 0.0;      ///< rigid motion of holder and cell
  double contours_us = 0.0;   ///< both snakes, all attempts
  double report_us = 0.0;     ///< state, confidence, the observation itself
  double detection_us = 0.0;  ///< search of the whole image for a cell and its tools
};

/// Adds the time until its end to a part.
class PartTimer {
 public:
  explicit PartTimer(double& part_us) noexcept : part_us_(part_us) {}
  PartTimer(const PartTimer&) = delete;
  PartTimer& operator=(const PartTimer&) = delete;
  ~PartTimer() { part_us_ += std::chrono::duration<double, std::micro>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double& part_us_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace pellucida
