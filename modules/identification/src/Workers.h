#pragma once
#include <functional>

namespace pellucida {

/// Calls `job(0)` .. `job(count - 1)`, in at most `threads` threads at once (0: one a core). Returns when all are done;
/// rethrows the exception of the job with the smallest number.
void run_jobs(int count, int threads, const std::function<void(int)>& job);

}  // namespace pellucida
