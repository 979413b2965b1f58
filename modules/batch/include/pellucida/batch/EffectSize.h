#pragma once
#include <cstdint>
#include <vector>

namespace pellucida {

/// How far two samples lie apart, with a 95 % interval. NaN where it can't be said.
struct EffectSize {
  double value = 0.0;
  double lower = 0.0, upper = 0.0;
};

/// Hedges' g: the difference of the means, `values` less `reference`, over their pooled standard deviation, times
/// J = Gamma(m/2) / (sqrt(m/2) Gamma((m-1)/2)), m = n1 + n2 - 2, which takes away the bias of small samples (J. Educ.
/// Stat. 6, 1981, 107). NaN with fewer than 2 values in a sample or without spread.
double hedges_g(const std::vector<double>& reference, const std::vector<double>& values) noexcept;

/// Cliff's delta: the share of pairs in which `values` is the larger less the share in which it is the smaller, -1..1
/// (Psychol. Bull. 114, 1993, 494). NaN where a sample is empty.
double cliffs_delta(const std::vector<double>& reference, const std::vector<double>& values) noexcept;

/// Either with its percentile bootstrap interval: both samples drawn anew 2000 times from a fixed seed. Without an
/// interval where a sample has fewer than `kLeastForInterval` values. NaN values are ignored.
inline constexpr int kLeastForInterval = 4;
using EffectFunction = double (*)(const std::vector<double>&, const std::vector<double>&) noexcept;
EffectSize effect_size(EffectFunction effect, std::vector<double> reference, std::vector<double> values,
                       std::uint64_t seed = 1);

}  // namespace pellucida
