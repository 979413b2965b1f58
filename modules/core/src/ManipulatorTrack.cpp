#include "pellucida/core/ManipulatorTrack.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

constexpr double kLongestGap_s = 0.25, kLongestAhead_s = 0.05;
constexpr double kSteps_per_um = 1000.0;

Eigen::Vector2d as_kept(const Eigen::Vector2d& place_um) {
  return {std::round(kSteps_per_um * place_um.x()) / kSteps_per_um,
          std::round(kSteps_per_um * place_um.y()) / kSteps_per_um};
}

}  // namespace

void ManipulatorTrack::add(double time_s, const Eigen::Vector2d& tip_um,
                           const Eigen::Vector2d& velocity_um_per_s) noexcept {
  if (!std::isfinite(time_s) || !tip_um.allFinite() || !velocity_um_per_s.allFinite()) return;
  const std::lock_guard lock(mutex_);
  if (count_ > 0 && !(time_s > newest(0).time_s)) return;
  reports_[count_ % kReports] = {time_s, tip_um, velocity_um_per_s};
  ++count_;
}

std::optional<Eigen::Vector2d> ManipulatorTrack::at(double time_s) const noexcept {
  const std::lock_guard lock(mutex_);
  if (count_ == 0 || !std::isfinite(time_s)) return std::nullopt;
  const Report& last = newest(0);
  if (time_s >= last.time_s) {
    if (time_s - last.time_s > kLongestAhead_s) return std::nullopt;
    return as_kept(last.tip_um + (time_s - last.time_s) * last.velocity_um_per_s);
  }
  const std::size_t kept = std::min(count_, kReports);
  for (std::size_t back = 1; back < kept; ++back) {
    const Report& before = newest(back);
    if (before.time_s > time_s) continue;
    const Report& after = newest(back - 1);
    const double gap_s = after.time_s - before.time_s;
    if (gap_s > kLongestGap_s) return std::nullopt;
    const double share = (time_s - before.time_s) / gap_s;
    return as_kept(before.tip_um + share * (after.tip_um - before.tip_um));
  }
  return std::nullopt;
}

}  // namespace pellucida
