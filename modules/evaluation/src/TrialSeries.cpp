#include "pellucida/evaluation/TrialSeries.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "pellucida/core/Error.h"

namespace pellucida {

std::vector<TrialOutcome> run_series(const TrialScene& scene, const SeriesOptions& options,
                                     const std::function<void(long done, long all)>& progress) {
  if (options.trials < 1)
    throw UsageError("series.trials is " + std::to_string(options.trials) + "; it must be at least 1");
  if (options.jobs < 0) throw UsageError("series.jobs is " + std::to_string(options.jobs) + "; it must be 0 or above");
  const auto trials = static_cast<std::size_t>(options.trials);
  std::vector<TrialOutcome> outcomes(trials * options.modalities.size());
  std::vector<char> finished(outcomes.size(), 0);

  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  long done = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < outcomes.size(); k = next++) {
      if (options.stopped && options.stopped()) return;
      try {
        TrialOptions trial = options.trial;
        trial.modality = options.modalities[k / trials];
        trial.seed = options.seed + k % trials;
        outcomes[k] = run_trial(scene, trial);
        finished[k] = 1;
      } catch (...) {
        std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = outcomes.size();
        return;
      }
      std::lock_guard lock(mutex);
      ++done;
      if (progress) progress(done, static_cast<long>(outcomes.size()));
    }
  };
  const unsigned wanted =
      options.jobs > 0 ? static_cast<unsigned>(options.jobs) : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> threads;
    const std::size_t count = std::min<std::size_t>(wanted, outcomes.size());
    for (std::size_t k = 1; k < count; ++k) threads.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  std::vector<TrialOutcome> done_ones;
  done_ones.reserve(outcomes.size());
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    if (finished[k] != 0) done_ones.push_back(std::move(outcomes[k]));
  }
  return done_ones;
}

}  // namespace pellucida
