#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace pellucida {

/// A sample in four numbers. All NaN for an empty one.
struct Estimate {
  int count = 0;  ///< values that are numbers
  double median = 0.0, mean = 0.0;
  double lower = 0.0, upper = 0.0;  ///< 95 % interval of the mean
};

/// The quantile at `part` (0..1) of sorted values, at least one, linear between neighbours (type 7 of Hyndman and Fan,
/// Am. Stat. 50, 1996: what R and NumPy give unasked).
double quantile(std::span<const double> sorted, double part);

/// Median, mean and its percentile bootstrap interval (2000 resamples, seeded: Efron and Tibshirani, An Introduction to
/// the Bootstrap, 1993, chapter 13). NaN values are ignored.
Estimate estimate(std::vector<double> values, std::uint64_t seed = 1);

/// A share of successes with Wilson's 95 % score interval (J. Am. Stat. Assoc. 22, 1927).
struct Share {
  double value = 0.0, lower = 0.0, upper = 1.0;  ///< 0..1
};
/// `count` 0: value NaN, interval 0..1.
Share share_of(int successes, int count) noexcept;

}  // namespace pellucida
