#include "pellucida/core/Statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace pellucida {
namespace {

constexpr int kResamples = 2000;

}  // namespace

double quantile(std::span<const double> sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto before = static_cast<std::size_t>(place);
  const std::size_t after = std::min(before + 1, sorted.size() - 1);
  const double rest = place - static_cast<double>(before);
  return (1.0 - rest) * sorted[before] + rest * sorted[after];
}

Estimate estimate(std::vector<double> values, std::uint64_t seed) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  Estimate result;
  result.count = static_cast<int>(values.size());
  if (values.empty()) {
    result.median = result.mean = result.lower = result.upper = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  std::sort(values.begin(), values.end());
  result.median = quantile(values, 0.5);
  const auto count = static_cast<double>(values.size());
  result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;

  std::mt19937_64 random(seed);
  std::vector<double> means(kResamples);
  for (double& mean : means) {
    double sum = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) sum += values[random() % values.size()];
    mean = sum / count;
  }
  std::sort(means.begin(), means.end());
  result.lower = quantile(means, 0.025);
  result.upper = quantile(means, 0.975);
  return result;
}

Share share_of(int successes, int count) noexcept {
  if (count <= 0) return {std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0};
  constexpr double z = 1.959964;
  const double n = count, p = successes / n, z2 = z * z;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = z / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace pellucida
