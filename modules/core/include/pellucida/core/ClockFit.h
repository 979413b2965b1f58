#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace pellucida {

/// How one clock runs against another: run_s = offset_s + (1 + drift_ppm * 1e-6) * device_s.
///
/// The least delay on the way from the device is part of the offset: stamps alone can't tell the two apart.
struct ClockFit {
  double offset_s = 0.0;         ///< at the device's time 0
  double drift_ppm = 0.0;        ///< positive: the device's clock runs slow
  double drift_sigma_ppm = 0.0;  ///< standard deviation
  double scatter_s = 0.0;        ///< robust standard deviation of the pairs about the line
  std::size_t pair_count = 0;    ///< pairs that the line was fitted to

  double run_s(double device_s) const noexcept { return offset_s + (1.0 + 1e-6 * drift_ppm) * device_s; }
};

/// Pairs of one moment's times on two clocks, and the line through them. A stamp of the run's clock is taken when the
/// device's message arrives: late by a delay that varies, never early. So of each stretch of time the pair with the
/// least delay is kept; stretches grow so that a run of any length needs the same memory. One thread at a time.
class ClockPairs {
 public:
  struct Pair {
    double device_s = 0.0;
    double run_s = 0.0;
  };

  /// Both finite; `device_s` must not fall behind that of an earlier call (such a pair is passed over).
  void add(double device_s, double run_s);

  /// The median of the slopes between all kept pairs (Theil and Sen) and the median offset from it; from 8 pairs on
  /// that span 5 s.
  std::optional<ClockFit> fit() const;

  /// The pairs kept, in the order of time.
  const std::vector<Pair>& pairs() const noexcept { return kept_; }

 private:
  void merge();

  std::vector<Pair> kept_;
  std::size_t stretch_ = 0;  // of the newest pair, counted in `stretch_s_`
  double first_s_ = 0.0;
  double stretch_s_ = 0.5;
};

}  // namespace pellucida
