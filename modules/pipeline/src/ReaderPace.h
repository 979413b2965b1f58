#pragma once
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>

#include "pellucida/core/Clock.h"
#include "pellucida/core/PaceFigures.h"

namespace pellucida {

/// What a reader of frames does next.
enum class ReaderTurn {
  kRead,     ///< the next frame
  kPaused,   ///< nothing: a pause begins; the next call waits for its end
  kResumed,  ///< the pause is over
  kRestart,  ///< begin anew from the first frame
  kStop      ///< end
};

/// Paces the thread that reads frames: pause, restart, the end of the source, and the moment a frame of a recording is
/// due. `next_turn`, `end` and `wait_until_due` are the reader's; the others may come from any thread, and none of
/// those waits.
class ReaderPace {
 public:
  /// `clock` must outlive the pace. `speed_ratio`: of a recording, 1 = its own; above 0.
  explicit ReaderPace(const Clock& clock, double speed_ratio = 1.0) : clock_(clock), speed_ratio_(speed_ratio) {}

  void set_paused(bool paused) {
    {
      std::lock_guard lock(mutex_);
      paused_ = paused;
    }
    wake_.notify_all();
  }
  bool paused() const {
    std::lock_guard lock(mutex_);
    return paused_;
  }

  /// The reader's next turn is a restart, also during a pause.
  void ask_restart() {
    {
      std::lock_guard lock(mutex_);
      restart_wanted_ = true;
    }
    wake_.notify_all();
  }

  /// True from the end of the source to a restart.
  bool ended() const {
    std::lock_guard lock(mutex_);
    return ended_;
  }

  /// Blocks while the run is paused or the source at its end.
  ReaderTurn next_turn(std::stop_token stop) {
    std::unique_lock lock(mutex_);
    if (stop.stop_requested()) return ReaderTurn::kStop;
    if (paused_ && !resting_ && !restart_wanted_) {
      resting_ = true;
      return ReaderTurn::kPaused;
    }
    if (!wake_.wait(lock, stop, [&] { return restart_wanted_ || (!paused_ && (!ended_ || resting_)); })) {
      return ReaderTurn::kStop;
    }
    if (restart_wanted_) {
      restart_wanted_ = false;
      ended_ = false;
      due_offset_s_.reset();
      return ReaderTurn::kRestart;
    }
    if (resting_) {
      resting_ = false;
      due_offset_s_.reset();
      return ReaderTurn::kResumed;
    }
    return ReaderTurn::kRead;
  }

  /// The source has no more frames.
  void end() {
    std::lock_guard lock(mutex_);
    ended_ = true;
  }

  /// Sleeps until a frame of `time_s` (of a recording) is due; the pace begins anew after a pause or a restart. A frame
  /// that comes too late does not move those after it. False when `stop` is requested.
  bool wait_until_due(double time_s, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    const double played_s = time_s / speed_ratio_;
    if (!due_offset_s_) {
      due_offset_s_ = clock_.now_s() - played_s;
      figures_ = {.speed_ratio = speed_ratio_, .first_time_s = time_s, .first_wall_s = clock_.now_s()};
    }
    const double due_s = *due_offset_s_ + played_s;
    const double wait_s = due_s - clock_.now_s();
    if (wait_s > 0.0) wake_.wait_for(lock, stop, std::chrono::duration<double>(wait_s), [] { return false; });
    figures_.last_time_s = time_s;
    figures_.last_wall_s = clock_.now_s();
    figures_.largest_lateness_s = std::max(figures_.largest_lateness_s, figures_.last_wall_s - due_s);
    return !stop.stop_requested();
  }

  /// How well the frames kept their time since the pace last began.
  PaceFigures figures() const {
    std::lock_guard lock(mutex_);
    return figures_;
  }

 private:
  const Clock& clock_;
  const double speed_ratio_;
  PaceFigures figures_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  bool paused_ = false;
  bool restart_wanted_ = false;
  bool ended_ = false;
  bool resting_ = false;                // the reader knows of a pause, not yet of its end
  std::optional<double> due_offset_s_;  // the clock less the recording's time
};

}  // namespace pellucida
