#pragma once
#include <chrono>
#include <thread>

namespace pellucida {

/// Waits until `condition` holds. It has no deadline of its own: a test that waits too long is ended by CTest.
template <class Condition>
void eventually(Condition condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace pellucida
