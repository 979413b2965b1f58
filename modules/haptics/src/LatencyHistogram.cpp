#include "pellucida/haptics/LatencyHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace pellucida {

std::size_t LatencyHistogram::bin_of(std::uint64_t ns) noexcept {
  constexpr std::uint64_t kSub = 1U << kSubBits;
  if (ns < kSub) return static_cast<std::size_t>(ns);
  // The octave and, within it, the five bits after the leading one.
  const auto octave = static_cast<unsigned>(std::bit_width(ns)) - 1 - kSubBits;
  return ((static_cast<std::size_t>(octave) + 1) << kSubBits) + static_cast<std::size_t>((ns >> octave) - kSub);
}

double LatencyHistogram::upper_edge_ns(std::size_t bin) noexcept {
  constexpr std::size_t kSub = 1U << kSubBits;
  if (bin < kSub) return static_cast<double>(bin);
  const int octave = static_cast<int>(bin >> kSubBits) - 1;
  return std::ldexp(static_cast<double>((bin & (kSub - 1)) + kSub + 1), octave) - 1.0;
}

void LatencyHistogram::add_ns(std::int64_t duration_ns) noexcept {
  const std::int64_t ns = std::max<std::int64_t>(duration_ns, 0);
  // One writer: a load and a store are enough and cheaper than a locked addition.
  auto& bin = bins_[bin_of(static_cast<std::uint64_t>(ns))];
  bin.store(bin.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  count_.store(count_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  if (ns > max_ns_.load(std::memory_order_relaxed)) max_ns_.store(ns, std::memory_order_relaxed);
}

void LatencyHistogram::clear() noexcept {
  for (auto& bin : bins_) bin.store(0, std::memory_order_relaxed);
  count_.store(0, std::memory_order_relaxed);
  max_ns_.store(0, std::memory_order_relaxed);
}

void LatencyHistogram::add(const LatencyHistogram& other) noexcept {
  for (std::size_t k = 0; k < kBinCount; ++k) bins_[k] += other.bins_[k].load(std::memory_order_relaxed);
  count_ += other.count_.load(std::memory_order_relaxed);
  max_ns_ = std::max(max_ns_.load(), other.max_ns_.load(std::memory_order_relaxed));
}

double LatencyHistogram::quantile_us(double ratio) const noexcept {
  std::uint64_t total = 0;
  for (const auto& bin : bins_) total += bin.load(std::memory_order_relaxed);
  if (total == 0) return 0.0;
  const double wanted = std::clamp(ratio, 0.0, 1.0) * static_cast<double>(total);
  std::uint64_t seen = 0;
  for (std::size_t k = 0; k < kBinCount; ++k) {
    seen += bins_[k].load(std::memory_order_relaxed);
    if (static_cast<double>(seen) >= wanted && seen > 0) return std::min(1e-3 * upper_edge_ns(k), max_us());
  }
  return max_us();
}

LatencySummary summarize(const LatencyHistogram& histogram) noexcept {
  return {histogram.quantile_us(0.5),    histogram.quantile_us(0.99), histogram.quantile_us(0.999),
          histogram.quantile_us(0.9999), histogram.max_us(),          histogram.count()};
}

}  // namespace pellucida
