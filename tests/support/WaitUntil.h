#pragma once
#include <chrono>
#include <functional>
#include <thread>

namespace pellucida::test {

/// Asks every 10 ms; false after four minutes, which are for a busy machine under a sanitizer.
inline bool wait_until(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(4);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace pellucida::test
