#pragma once
#include <optional>

namespace pellucida {

/// Frames, one after the other, to which the same thing happened.
struct FrameStretch {
  long first_frame = 0;
  long last_frame = 0;
  long frame_count = 0;  ///< how many frames it happened to: others may lie in between
  double begin_s = 0.0;  ///< time of the first of them
  double end_s = 0.0;    ///< time of the last of them
};

/// Gathers frames to which something happened into stretches, so that a table gets a row for each stretch and not for
/// each frame. A stretch ends when nothing has happened for `kQuiet_s`, or after `kLongest_s`.
class FrameStretchFinder {
 public:
  static constexpr double kQuiet_s = 2.0;
  static constexpr double kLongest_s = 60.0;

  /// The next frame, in the order of time, and how many it happened to: this one (1), those lost before it, or none
  /// (0). The stretch that this frame ends, if it does.
  std::optional<FrameStretch> add(long frame, double time_s, long count) {
    std::optional<FrameStretch> ended;
    if (now_ && (time_s - now_->end_s > kQuiet_s || time_s - now_->begin_s > kLongest_s)) ended = finish();
    if (count == 0) return ended;
    if (!now_) now_ = FrameStretch{.first_frame = frame, .begin_s = time_s};
    now_->last_frame = frame;
    now_->end_s = time_s;
    now_->frame_count += count;
    return ended;
  }

  /// The stretch that was not over yet, if there was one.
  std::optional<FrameStretch> finish() {
    const std::optional<FrameStretch> ended = now_;
    now_.reset();
    return ended;
  }

 private:
  std::optional<FrameStretch> now_;
};

}  // namespace pellucida
