#include "pellucida/operation/HapticWriter.h"

#include <algorithm>
#include <span>
#include <utility>

namespace pellucida {

HapticWriter::HapticWriter(WriteEvent write_event, WriteBlock write_block)
    : write_event_(std::move(write_event)), write_block_(std::move(write_block)) {}

void HapticWriter::write(double session_lag_s, std::size_t least_ticks) {
  std::span<const HapticRecord> left(ticks_);
  while (!left.empty() && left.size() >= least_ticks) {
    const auto block = left.first(std::min(left.size(), kBlockTicks));
    waiting_.push_back({make_haptic_path_block(block, session_lag_s), block.front().time_s - session_lag_s});
    left = left.subspan(block.size());
  }
  ticks_.erase(ticks_.begin(), ticks_.end() - static_cast<std::ptrdiff_t>(left.size()));
  auto next = waiting_.begin();
  while (next != waiting_.end() && write_block_(next->paths, next->time_s)) ++next;
  waiting_.erase(waiting_.begin(), next);
}

void HapticWriter::flush(double now_s, double session_lag_s) {
  for (const Event& event : limits_.take(now_s, session_lag_s)) write_event_(event);
  write(session_lag_s, kBlockTicks);
}

void HapticWriter::finish(double session_lag_s) {
  for (const Event& event : limits_.finish(session_lag_s)) write_event_(event);
  write(session_lag_s, 1);
}

}  // namespace pellucida
