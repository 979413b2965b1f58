#include "pellucida/pipeline/Distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pellucida {

double Distribution::quantile(double quantile) const {
  if (values_.empty()) return 0.0;
  auto sorted = values_;
  const auto n = static_cast<double>(sorted.size());
  const auto rank = static_cast<std::size_t>(std::clamp(std::ceil(quantile * n) - 1.0, 0.0, n - 1.0));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank), sorted.end());
  return sorted[rank];
}

double Distribution::mean() const {
  if (values_.empty()) return 0.0;
  return std::accumulate(values_.begin(), values_.end(), 0.0) / static_cast<double>(values_.size());
}

}  // namespace pellucida
