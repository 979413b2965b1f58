#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace pellucida {

/// The upper median of `values`, 0 of none. Puts them into another order.
inline double median_of(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace pellucida
