#pragma once
#include <cstddef>
#include <vector>

namespace pellucida {

/// Samples of one quantity, and the order statistics that `bench --json` reports.
class Distribution {
 public:
  void add(double value) { values_.push_back(value); }
  void add(const Distribution& other) { values_.insert(values_.end(), other.values_.begin(), other.values_.end()); }
  std::size_t count() const noexcept { return values_.size(); }

  /// The smallest sample that at least the share `quantile` (0..1) of all samples does not exceed; 0 without samples.
  double quantile(double quantile) const;
  double max() const { return quantile(1.0); }
  double mean() const;

 private:
  std::vector<double> values_;
};

}  // namespace pellucida
