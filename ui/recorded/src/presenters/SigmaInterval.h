#pragma once
#include <utility>

namespace pellucida {

/// The ends of the 95 % interval of a magnitude with a standard deviation, not below 0; NaN where that is NaN.
inline std::pair<double, double> sigma_interval(double magnitude, double sigma) {
  constexpr double kTwoSided95 = 1.959964;
  const double half = kTwoSided95 * sigma;
  return {magnitude - half < 0.0 ? 0.0 : magnitude - half, magnitude + half};
}

}  // namespace pellucida
