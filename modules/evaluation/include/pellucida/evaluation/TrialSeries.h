#pragma once
#include <functional>
#include <vector>

#include "pellucida/evaluation/Trial.h"

namespace pellucida {

/// Many trials: each seed once in each modality.
struct SeriesOptions {
  TrialOptions trial;  ///< modality and seed are the series' own
  std::vector<Modality> modalities{Modality::kFlatImage, Modality::kSpace, Modality::kSpaceAndHaptics,
                                   Modality::kSpaceAndFixture};
  int trials = 200;               ///< of each modality, at least 1
  std::uint64_t seed = 1;         ///< of the first trial; the next ones count on from there
  int jobs = 0;                   ///< threads; 0: one a core
  std::function<bool()> stopped;  ///< asked before each trial, from any thread: no more are begun; none: never
};

/// The outcomes by modality in the order given, then by seed: the same whatever the number of threads. Of a series that
/// is stopped, those that were done. `progress` is
/// called with the number done and the total, from any of the threads, one at a time. Throws what `run_trial` throws;
/// UsageError for numbers out of range.
std::vector<TrialOutcome> run_series(const TrialScene& scene, const SeriesOptions& options,
                                     const std::function<void(long done, long all)>& progress = {});

}  // namespace pellucida
