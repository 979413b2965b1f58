#pragma once
#include <array>
#include <cstddef>
#include <limits>

#include "pellucida/mechanics/ForceEstimate.h"

namespace pellucida {

/// Which warnings of a frame are news: one that has not been there for `kQuiet_s`. One that comes and goes with each
/// passing loss of contact is reported once.
class WarningNews {
 public:
  static constexpr double kQuiet_s = 5.0;

  /// The next frame's warnings, in the order of time; those of them to report.
  ForceWarning add(unsigned warnings, double time_s) {
    unsigned news = 0;
    for (std::size_t bit = 0; bit < seen_s_.size(); ++bit) {
      const unsigned mask = 1U << bit;
      if ((warnings & mask) == 0U) continue;
      if (time_s - seen_s_[bit] > kQuiet_s) news |= mask;
      seen_s_[bit] = time_s;
    }
    return static_cast<ForceWarning>(news);
  }

  /// Another cell, another run.
  void clear() { seen_s_.fill(kNever_s); }

 private:
  static constexpr double kNever_s = -std::numeric_limits<double>::infinity();
  static constexpr std::size_t kBitCount = 8;  // there may be as many kinds of warning
  std::array<double, kBitCount> seen_s_ = [] {
    std::array<double, kBitCount> never{};
    never.fill(kNever_s);
    return never;
  }();
};

}  // namespace pellucida
