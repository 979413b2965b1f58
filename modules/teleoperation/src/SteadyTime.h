#pragma once
#include <chrono>

namespace pellucida {

/// Seconds on the machine's monotonic clock, from an arbitrary start: for spans and deadlines alone.
inline double steady_now_s() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace pellucida
