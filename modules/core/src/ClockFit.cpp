#include "pellucida/core/ClockFit.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr std::size_t kMostPairs = 256;
constexpr std::size_t kLeastPairs = 8;
constexpr double kLeastSpan_s = 5.0;
// Of a normal distribution: standard deviation over median absolute deviation, and of the median over that of the mean.
constexpr double kSigmaOfMad = 1.4826;
constexpr double kSigmaOfMedian = 1.2533;

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double delay_of(const ClockPairs::Pair& pair) {
  return pair.run_s - pair.device_s;
}

}  // namespace

void ClockPairs::add(double device_s, double run_s) {
  if (!std::isfinite(device_s) || !std::isfinite(run_s)) return;
  if (kept_.empty()) first_s_ = device_s;
  if (!kept_.empty() && device_s < kept_.back().device_s) return;
  const auto stretch = static_cast<std::size_t>((device_s - first_s_) / stretch_s_);
  const Pair pair{device_s, run_s};
  if (kept_.empty() || stretch != stretch_) {
    kept_.push_back(pair);
    stretch_ = stretch;
  } else if (delay_of(pair) < delay_of(kept_.back())) {
    kept_.back() = pair;
  }
  if (kept_.size() > kMostPairs) merge();
}

// Two stretches become one. Within a stretch the drift is far below the delays.
void ClockPairs::merge() {
  stretch_s_ *= 2.0;
  std::vector<Pair> merged;
  std::size_t last = 0;
  for (const Pair& pair : kept_) {
    const auto stretch = static_cast<std::size_t>((pair.device_s - first_s_) / stretch_s_);
    if (merged.empty() || stretch != last) {
      merged.push_back(pair);
    } else if (delay_of(pair) < delay_of(merged.back())) {
      merged.back() = pair;
    }
    last = stretch;
  }
  kept_ = std::move(merged);
  stretch_ = last;
}

std::optional<ClockFit> ClockPairs::fit() const {
  if (kept_.size() < kLeastPairs || kept_.back().device_s - kept_.front().device_s < kLeastSpan_s) return std::nullopt;
  std::vector<double> slopes;
  slopes.reserve(kept_.size() * (kept_.size() - 1) / 2);
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    for (std::size_t k = i + 1; k < kept_.size(); ++k) {
      const double span_s = kept_[k].device_s - kept_[i].device_s;
      if (span_s > 0.0) slopes.push_back((delay_of(kept_[k]) - delay_of(kept_[i])) / span_s);
    }
  }
  if (slopes.empty()) return std::nullopt;
  const double slope = median_of(slopes);
  std::vector<double> rests;
  double mean_s = 0.0;
  for (const Pair& pair : kept_) {
    rests.push_back(delay_of(pair) - slope * pair.device_s);
    mean_s += pair.device_s / static_cast<double>(kept_.size());
  }
  ClockFit fit;
  fit.pair_count = kept_.size();
  fit.drift_ppm = 1e6 * slope;
  fit.offset_s = median_of(rests);
  double spread_s2 = 0.0;
  std::vector<double> distances;
  for (const Pair& pair : kept_) {
    distances.push_back(std::abs(delay_of(pair) - slope * pair.device_s - fit.offset_s));
    spread_s2 += (pair.device_s - mean_s) * (pair.device_s - mean_s);
  }
  fit.scatter_s = kSigmaOfMad * median_of(distances);
  fit.drift_sigma_ppm = 1e6 * kSigmaOfMedian * fit.scatter_s / std::sqrt(spread_s2);
  return fit;
}

}  // namespace pellucida
