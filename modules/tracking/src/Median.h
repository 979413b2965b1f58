#pragma once
#include <Eigen/Core>
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

/// The same of a vector's values, which stay as they are.
inline double median_of(const Eigen::VectorXd& values) {
  std::vector<double> copy(values.begin(), values.end());
  return median_of(copy);
}

}  // namespace pellucida
