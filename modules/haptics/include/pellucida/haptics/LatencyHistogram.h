#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace pellucida {

/// Durations counted in fixed bins whose width is 1/32 of their value or less (1 ns below 32 ns): percentiles to 3 %,
/// the largest exactly. One thread adds, any thread reads; nothing allocates, locks or throws. About 10 kB.
class LatencyHistogram {
 public:
  /// The writer's thread only. A negative duration counts as 0.
  void add_ns(std::int64_t duration_ns) noexcept;

  /// The writer's thread only, or any while there is no writing.
  void clear() noexcept;

  /// Adds another's durations. Only while neither is being written.
  void add(const LatencyHistogram& other) noexcept;

  std::uint64_t count() const noexcept { return count_.load(std::memory_order_relaxed); }
  double max_us() const noexcept { return 1e-3 * static_cast<double>(max_ns_.load(std::memory_order_relaxed)); }

  /// The upper edge of the bin where the share `ratio` (0..1) of all durations is reached; 0 while empty.
  double quantile_us(double ratio) const noexcept;

 private:
  static constexpr unsigned kSubBits = 5;  ///< 32 bins an octave
  static constexpr std::size_t kBinCount = (64 - kSubBits) << kSubBits;
  static std::size_t bin_of(std::uint64_t ns) noexcept;
  static double upper_edge_ns(std::size_t bin) noexcept;

  std::array<std::atomic<std::uint32_t>, kBinCount> bins_{};
  std::atomic<std::uint64_t> count_{0};
  std::atomic<std::int64_t> max_ns_{0};
};

/// The percentiles as a report shows them, us.
struct LatencySummary {
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p99_9_us = 0.0;
  double p99_99_us = 0.0;
  double max_us = 0.0;
  std::uint64_t count = 0;
};
LatencySummary summarize(const LatencyHistogram& histogram) noexcept;

}  // namespace pellucida
