#include "Workers.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace pellucida {

void run_jobs(int count, int threads, const std::function<void(int)>& job) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int used = std::clamp(threads > 0 ? threads : cores, 1, std::max(1, count));
  std::vector<std::exception_ptr> faults(static_cast<std::size_t>(count));
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int k = next++; k < count; k = next++) {
      try {
        job(k);
      } catch (...) {
        faults[static_cast<std::size_t>(k)] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int n = 1; n < used; ++n) others.emplace_back(work);
    work();
  }
  for (const auto& fault : faults) {
    if (fault) std::rethrow_exception(fault);
  }
}

}  // namespace pellucida
