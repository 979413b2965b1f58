#include "BlockWatch.h"

#include <utility>

namespace pellucida {

BlockWatch::Event::Event(BlockWatch& watch, int loop_level) noexcept
    : watch_(watch), level_(loop_level), outer_level_(std::exchange(watch.handled_level_, loop_level)) {
  if (level_ != outer_level_) watch_.event_begin_ = Clock::now();
}

BlockWatch::Event::~Event() {
  watch_.handled_level_ = outer_level_;
  if (level_ != outer_level_) watch_.end_event();
}

void BlockWatch::begin() noexcept {
  begin_ = event_begin_ = Clock::now();
  figures_ = {};
}

BlockFigures BlockWatch::figures() const noexcept {
  BlockFigures figures = figures_;
  figures.watched_s = std::chrono::duration<double>(Clock::now() - begin_).count();
  return figures;
}

// The event that a loop inside ended in goes on from here.
void BlockWatch::end_event() noexcept {
  const auto now = Clock::now();
  const double taken_ms = std::chrono::duration<double, std::milli>(now - event_begin_).count();
  event_begin_ = now;
  if (taken_ms > kBlock_ms) ++figures_.count;
  if (taken_ms <= figures_.longest_ms) return;
  figures_.longest_ms = taken_ms;
  figures_.longest_at_s = std::chrono::duration<double>(now - begin_).count();
}

BlockWatch& window_blocks() noexcept {
  static BlockWatch watch;
  return watch;
}

}  // namespace pellucida
