#include "pellucida/batch/EffectSize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "pellucida/core/Statistics.h"

namespace pellucida {
namespace {

constexpr int kDraws = 2000;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double mean_of(const std::vector<double>& values) noexcept {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double square_sum_of(const std::vector<double>& values, double mean) noexcept {
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

// With replacement. The generator's own numbers: a distribution's differ between libraries.
void draw(const std::vector<double>& values, std::mt19937_64& random, std::vector<double>& drawn) {
  drawn.resize(values.size());
  for (double& value : drawn) value = values[random() % values.size()];
}

}  // namespace

double hedges_g(const std::vector<double>& reference, const std::vector<double>& values) noexcept {
  if (reference.size() < 2 || values.size() < 2) return kUnknown;
  const double reference_mean = mean_of(reference), mean = mean_of(values);
  const double freedom = static_cast<double>(reference.size() + values.size()) - 2.0;
  const double sd = std::sqrt((square_sum_of(reference, reference_mean) + square_sum_of(values, mean)) / freedom);
  // Equal values leave no more than rounding.
  if (!(sd > 1e-12 * std::max(std::abs(mean), std::abs(reference_mean)))) return kUnknown;
  const double correction =
      std::exp(std::lgamma(0.5 * freedom) - std::lgamma(0.5 * (freedom - 1.0))) / std::sqrt(0.5 * freedom);
  return correction * (mean - reference_mean) / sd;
}

double cliffs_delta(const std::vector<double>& reference, const std::vector<double>& values) noexcept {
  if (reference.empty() || values.empty()) return kUnknown;
  long balance = 0;
  for (const double value : values) {
    for (const double other : reference) balance += (value > other) - (value < other);
  }
  return static_cast<double>(balance) / (static_cast<double>(values.size()) * static_cast<double>(reference.size()));
}

EffectSize effect_size(EffectFunction effect, std::vector<double> reference, std::vector<double> values,
                       std::uint64_t seed) {
  for (auto* sample : {&reference, &values}) std::erase_if(*sample, [](double value) { return std::isnan(value); });
  EffectSize result{effect(reference, values), kUnknown, kUnknown};
  if (std::isnan(result.value) || std::min(reference.size(), values.size()) < kLeastForInterval) return result;

  std::mt19937_64 random(seed);
  std::vector<double> drawn_reference, drawn_values, effects;
  for (int k = 0; k < kDraws; ++k) {
    draw(reference, random, drawn_reference);
    draw(values, random, drawn_values);
    const double drawn = effect(drawn_reference, drawn_values);
    // A draw of one value many times has no spread to compare with.
    if (std::isfinite(drawn)) effects.push_back(drawn);
  }
  std::sort(effects.begin(), effects.end());
  result.lower = quantile(effects, 0.025);
  result.upper = quantile(effects, 0.975);
  return result;
}

}  // namespace pellucida
