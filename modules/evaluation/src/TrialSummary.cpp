#include "pellucida/evaluation/TrialSummary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "pellucida/haptics/LimitEvent.h"

namespace pellucida {
namespace {

constexpr std::array<TrialMetric, 12> kMetrics{{
    {"lateral_rms_um", "lateral RMS error, um", &TrialOutcome::lateral_rms_um},
    {"lateral_max_um", "largest lateral error, um", &TrialOutcome::lateral_max_um},
    {"duration_s", "whole trial, s", &TrialOutcome::duration_s},
    {"insertion_s", "insertion to deposit, s", &TrialOutcome::insertion_s},
    {"peak_approach_um_per_s", "peak approach speed, um/s", &TrialOutcome::peak_approach_um_per_s},
    {"mean_approach_um_per_s", "mean approach speed, um/s", &TrialOutcome::mean_approach_um_per_s},
    {"peak_after_puncture_um_per_s", "peak after puncture, um/s", &TrialOutcome::peak_after_puncture_um_per_s},
    {"peak_force_uN", "peak force on the cell, uN", &TrialOutcome::peak_force_uN},
    {"peak_hand_force_N", "peak force on the hand, N", &TrialOutcome::peak_hand_force_N},
    {"overshoot_um", "overshoot past target, um", &TrialOutcome::overshoot_um},
    {"deposit_error_um", "deposit's distance, um", &TrialOutcome::deposit_error_um},
    {"deposited_pL", "deposited, pL", &TrialOutcome::deposited_pL},
}};

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::vector<double> values_of(std::span<const TrialOutcome> outcomes, Modality modality, double TrialOutcome::*value) {
  std::vector<double> values;
  for (const TrialOutcome& outcome : outcomes)
    if (outcome.modality == modality) values.push_back(outcome.*value);
  return values;
}

}  // namespace

std::span<const TrialMetric> trial_metrics() noexcept {
  return kMetrics;
}

std::vector<ModalitySummary> summarize(std::span<const TrialOutcome> outcomes) {
  std::vector<ModalitySummary> summaries;
  for (const TrialOutcome& outcome : outcomes) {
    auto place = std::find_if(summaries.begin(), summaries.end(),
                              [&](const ModalitySummary& s) { return s.modality == outcome.modality; });
    if (place == summaries.end()) {
      summaries.emplace_back().modality = outcome.modality;
      place = std::prev(summaries.end());
    }
    ++place->count;
    place->punctured_count += outcome.punctured;
    place->deposited_count += outcome.deposited;
    place->removed_count += outcome.removed;
    place->success_count += outcome.success;
  }
  for (ModalitySummary& summary : summaries) {
    summary.success = share_of(summary.success_count, summary.count);
    for (const TrialMetric& metric : kMetrics)
      summary.metrics.push_back(estimate(values_of(outcomes, summary.modality, metric.value)));
  }
  return summaries;
}

Estimate paired_difference(std::span<const TrialOutcome> outcomes, Modality base, Modality other,
                           double TrialOutcome::*value) {
  std::map<std::uint64_t, double> of_base;
  for (const TrialOutcome& outcome : outcomes)
    if (outcome.modality == base) of_base[outcome.seed] = outcome.*value;
  std::vector<double> differences;
  for (const TrialOutcome& outcome : outcomes) {
    const auto pair = of_base.find(outcome.seed);
    if (outcome.modality == other && pair != of_base.end()) differences.push_back(outcome.*value - pair->second);
  }
  return estimate(differences);
}

std::string table_text(std::span<const ModalitySummary> summaries) {
  std::string text = "SIMULATED operator: median | mean [95 % interval of the mean]\n" + formatted("%-26s", "");
  for (const ModalitySummary& summary : summaries) text += formatted(" %28s", name_of(summary.modality));
  text += '\n';
  for (std::size_t k = 0; k < kMetrics.size(); ++k) {
    text += formatted("%-26s", kMetrics[k].title);
    for (const ModalitySummary& summary : summaries) {
      const Estimate& e = summary.metrics[k];
      text += formatted(" %28s", formatted("%.2f | %.2f [%.2f, %.2f]", e.median, e.mean, e.lower, e.upper).c_str());
    }
    text += '\n';
  }
  text += formatted("%-26s", "success [Wilson 95 %]");
  for (const ModalitySummary& summary : summaries) {
    const Share& s = summary.success;
    text += formatted(" %28s", formatted("%d of %d, %.0f %% [%.0f, %.0f]", summary.success_count, summary.count,
                                         100 * s.value, 100 * s.lower, 100 * s.upper)
                                   .c_str());
  }
  return text + '\n';
}

std::string effects_text(std::span<const TrialOutcome> outcomes) {
  std::string text;
  const auto has = [&](Modality modality) {
    return std::any_of(outcomes.begin(), outcomes.end(), [&](const auto& o) { return o.modality == modality; });
  };
  const bool haptics = has(Modality::kSpaceAndHaptics);
  if (haptics && has(Modality::kSpace)) {
    for (const auto& [title, value] : {std::pair{"peak approach speed", &TrialOutcome::peak_approach_um_per_s},
                                       std::pair{"mean approach speed", &TrialOutcome::mean_approach_um_per_s},
                                       std::pair{"peak after puncture", &TrialOutcome::peak_after_puncture_um_per_s}}) {
      const Estimate change = paired_difference(outcomes, Modality::kSpace, Modality::kSpaceAndHaptics, value);
      text += formatted("haptics, same simulated operator: %s %+.1f um/s [%+.1f, %+.1f]\n", title, change.mean,
                        change.lower, change.upper);
    }
  }
  if (haptics && has(Modality::kSpaceAndFixture)) {
    const double without =
        estimate(values_of(outcomes, Modality::kSpaceAndHaptics, &TrialOutcome::lateral_rms_um)).mean;
    const double with = estimate(values_of(outcomes, Modality::kSpaceAndFixture, &TrialOutcome::lateral_rms_um)).mean;
    text += formatted("guide, same simulated operator: lateral RMS error %.2f um instead of %.2f um, 1/%.1f\n", with,
                      without, without / with);
  }
  return text;
}

std::string limits_text(std::uint32_t mask) {
  std::string text;
  for (unsigned k = 0; k < static_cast<unsigned>(LimitKind::kCount); ++k) {
    const auto kind = static_cast<LimitKind>(k);
    if ((mask & limit_bit(kind)) == 0) continue;
    if (!text.empty()) text += "; ";
    text += to_string(kind);
  }
  return text;
}

}  // namespace pellucida
