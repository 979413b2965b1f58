#pragma once

namespace pellucida {

/// Numbers frames by their time stamps, and so counts the ones in between that never came. A frame that comes `n`
/// periods after the one before (rounded) has `n - 1` lost frames before it; jitter of less than half a period is no
/// loss, and a stamp that does not advance or goes back counts as the next frame.
class GapCounter {
 public:
  /// `frame_rate_hz` > 0.
  explicit GapCounter(double frame_rate_hz) : frame_rate_hz_(frame_rate_hz) {}

  struct Place {
    long frame_index = 0;  ///< 0 for the first frame; lost ones are counted
    long gap_count = 0;    ///< lost between the one before and this one
  };
  Place add(double time_s);

 private:
  double frame_rate_hz_;
  double last_time_s_ = 0.0;
  long last_index_ = -1;
};

}  // namespace pellucida
