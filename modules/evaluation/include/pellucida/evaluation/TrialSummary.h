#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "pellucida/core/Statistics.h"
#include "pellucida/evaluation/Trial.h"

namespace pellucida {

/// A number reported for each trial.
struct TrialMetric {
  const char* name;   ///< as in the files, with its unit
  const char* title;  ///< as in a table
  double TrialOutcome::*value;
};
std::span<const TrialMetric> trial_metrics() noexcept;

/// Summary of a modality's trials.
struct ModalitySummary {
  Modality modality = Modality::kFlatImage;
  int count = 0, punctured_count = 0, deposited_count = 0, removed_count = 0, success_count = 0;
  Share success;
  std::vector<Estimate> metrics;  ///< in the order of `trial_metrics`
};

/// By modality, in the order of their first trial.
std::vector<ModalitySummary> summarize(std::span<const TrialOutcome> outcomes);

/// The mean of `other` minus `base` over the seeds common to both, with its interval.
Estimate paired_difference(std::span<const TrialOutcome> outcomes, Modality base, Modality other,
                           double TrialOutcome::*value);

/// The table for a terminal; its first line states that the operator is simulated.
std::string table_text(std::span<const ModalitySummary> summaries);
/// The effects of haptics and guide, one line each, where the modalities are present.
std::string effects_text(std::span<const TrialOutcome> outcomes);

/// One row per trial; the column `operator` holds "simulated". An empty cell: not reached.
void write_trials_csv(std::ostream& stream, std::span<const TrialOutcome> outcomes);
/// One row per modality and metric, the success as `success_ratio`.
void write_summary_csv(std::ostream& stream, std::span<const ModalitySummary> summaries);

/// "puncture; passivity": the limits of a mask.
std::string limits_text(std::uint32_t mask);

}  // namespace pellucida
