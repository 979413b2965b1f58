#pragma once
#include <chrono>

namespace pellucida {

/// How long the window's thread kept away from its event loop.
struct BlockFigures {
  int count = 0;              ///< blocks: events that took longer than `BlockWatch::kBlock_ms`
  double longest_ms = 0.0;    ///< the longest event, a block or not
  double longest_at_s = 0.0;  ///< when it ended, s after `begin`
  double watched_s = 0.0;     ///< since `begin`
};

/// Measures how long a thread takes for each event before it returns to its loop. A loop inside an event, as a dialog
/// has, is no block: its own events are measured instead. One thread; allocates nothing.
class BlockWatch {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kBlock_ms = 50.0;

  /// Around the handling of an event; `loop_level`: how many event loops are running inside each other.
  class Event {
   public:
    Event(BlockWatch& watch, int loop_level) noexcept;
    ~Event();
    Event(const Event&) = delete;
    Event& operator=(const Event&) = delete;

   private:
    BlockWatch& watch_;
    int level_;
    int outer_level_;
  };

  /// Forgets all; figures count from here on.
  void begin() noexcept;
  BlockFigures figures() const noexcept;

 private:
  void end_event() noexcept;

  Clock::time_point begin_ = Clock::now();
  Clock::time_point event_begin_ = begin_;
  int handled_level_ = -1;  // of the loop whose event is being handled; -1: none is
  BlockFigures figures_;
};

/// That of the program's windows: fed by WindowProgram. Only on the windows' thread.
BlockWatch& window_blocks() noexcept;

}  // namespace pellucida
