#include "RobustSlope.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr std::size_t kMostSlopePoints = 400;

// The value of that rank, counted from 0 and rounded, of an ascending list.
double at_rank(const std::vector<double>& sorted, double rank) {
  const double last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(std::clamp(rank, 0.0, last)))];
}

double middle_of(const std::vector<double>& sorted) {
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

}  // namespace

std::optional<RobustSlope> robust_slope(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t count = std::min(x.size(), y.size());
  if (count < kFewestSlopePoints) return std::nullopt;
  const std::size_t stride = (count + kMostSlopePoints - 1) / kMostSlopePoints;
  std::vector<double> slopes;
  std::size_t used = 0;
  for (std::size_t i = 0; i < count; i += stride, ++used) {
    for (std::size_t j = i + stride; j < count; j += stride) {
      if (x[j] != x[i]) slopes.push_back((y[j] - y[i]) / (x[j] - x[i]));
    }
  }
  if (slopes.empty()) return std::nullopt;
  std::sort(slopes.begin(), slopes.end());
  const auto n = static_cast<double>(used);
  const auto pair_count = static_cast<double>(slopes.size());
  const double spread = kZ95 * std::sqrt(n * (n - 1.0) * (2.0 * n + 5.0) / 18.0);
  return RobustSlope{.value = middle_of(slopes),
                     .lower = at_rank(slopes, 0.5 * (pair_count - spread) - 1.0),
                     .upper = at_rank(slopes, 0.5 * (pair_count + spread))};
}

}  // namespace pellucida
