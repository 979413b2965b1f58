#pragma once
#include <cmath>

#include "ThicknessNetwork.h"

namespace pellucida {

/// The zona's thickness as the thickness network reads it, in the mean over the first frames of a cell.
class ReadThickness {
 public:
  /// Further frames would change little.
  bool is_full() const noexcept { return frames_ >= kFrames; }
  bool is_read() const noexcept { return frames_ > 0; }

  void add(const ThicknessReading& seen) {
    ++frames_;
    log_px_ += (std::log(seen.thickness_px) - log_px_) / frames_;
    log_sigma_ += (seen.log_sigma - log_sigma_) / frames_;
  }

  /// px; only where it is read.
  double mean_px() const { return std::exp(log_px_); }
  /// Standard deviation of its logarithm: what one frame shows wrong the next ones do too.
  double log_sigma() const noexcept { return log_sigma_; }

 private:
  static constexpr int kFrames = 8;
  double log_px_ = 0.0, log_sigma_ = 0.0;
  int frames_ = 0;
};

}  // namespace pellucida
