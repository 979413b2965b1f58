#include "ForceCurve.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/GivingWay.h"

namespace pellucida {
namespace {

constexpr double kHalfWindow_um = 2.5;

// Scatter of the force from row to row: second differences are blind to a ramp, and their median to a puncture.
double row_noise_uN(const std::vector<ForcePoint>& points) {
  std::vector<double> bends;
  for (std::size_t i = 2; i < points.size(); ++i) {
    bends.push_back(std::abs(points[i].force_uN - 2.0 * points[i - 1].force_uN + points[i - 2].force_uN));
  }
  if (bends.empty()) return 0.0;
  const auto middle = bends.begin() + static_cast<std::ptrdiff_t>(bends.size() / 2);
  std::nth_element(bends.begin(), middle, bends.end());
  // Of white noise: sqrt(1 + 4 + 1) sigma, and 0.6745 of that in the median.
  return *middle / (0.6745 * std::sqrt(6.0));
}

}  // namespace

ForceCurve::ForceCurve(std::span<const Measurement> rows, const RowRange& range, std::optional<std::size_t> puncture) {
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Measurement& m = rows[i];
    if (m.state != CellState::kContact || !std::isfinite(m.contact_force_uN) || !std::isfinite(m.indentation_um)) {
      continue;
    }
    const auto or_force = [&](double end_uN) { return std::isfinite(end_uN) ? end_uN : m.contact_force_uN; };
    points_.push_back({.row = i,
                       .time_s = m.time_s,
                       .depth_um = m.indentation_um,
                       .force_uN = m.contact_force_uN,
                       .lower_uN = or_force(m.contact_force_lower_uN),
                       .upper_uN = or_force(m.contact_force_upper_uN)});
    if (!puncture || i < *puncture) before_puncture_ = points_.size();
  }
  if (!puncture) return;
  before_puncture_ = count_before_giving_way(
      before_puncture_, rows[*puncture].time_s, [this](std::size_t k) { return points_[k].time_s; },
      [this](std::size_t k) { return points_[k].depth_um; });
}

std::size_t ForceCurve::strongest(std::size_t first) const noexcept {
  const std::size_t end = before_puncture_ > first ? before_puncture_ : points_.size();
  std::size_t best = first;
  for (std::size_t i = first; i < end; ++i) {
    if (points_[i].force_uN > points_[best].force_uN) best = i;
  }
  return best;
}

std::size_t ForceCurve::deepest() const noexcept {
  const std::size_t end = before_puncture_ > 0 ? before_puncture_ : points_.size();
  std::size_t best = 0;
  for (std::size_t i = 0; i < end; ++i) {
    if (points_[i].depth_um > points_[best].depth_um) best = i;
  }
  return best;
}

WorkInterval ForceCurve::work(std::size_t last, bool back_to_rest) const {
  // From rest to the first point, then from point to point.
  WorkInterval sum;
  double way_um2 = 0.0;
  ForcePoint before;
  const auto add = [&](const ForcePoint& to) {
    const double step_um = to.depth_um - before.depth_um;
    sum.value += 0.5 * (before.force_uN + to.force_uN) * step_um;
    sum.lower += 0.5 * (before.lower_uN + to.lower_uN) * step_um;
    sum.upper += 0.5 * (before.upper_uN + to.upper_uN) * step_um;
    way_um2 += step_um * step_um;
    before = to;
  };
  for (std::size_t i = 0; i <= last; ++i) add(points_[i]);
  if (back_to_rest) add(ForcePoint{});
  const double noise_pJ = kZ95 * row_noise_uN(points_) * std::sqrt(way_um2);
  const auto [least, most] = std::minmax({sum.value, sum.lower, sum.upper});
  return {.value = sum.value,
          .lower = sum.value - std::hypot(sum.value - least, noise_pJ),
          .upper = sum.value + std::hypot(most - sum.value, noise_pJ)};
}

WorkInterval ForceCurve::work_to(std::size_t last) const {
  return work(last, false);
}

WorkInterval ForceCurve::loop() const {
  return work(points_.size() - 1, true);
}

std::optional<RobustSlope> ForceCurve::stiffness_at(double depth_um) const {
  if (empty()) return std::nullopt;
  const std::size_t end = deepest();
  if (points_[end].depth_um < depth_um + kBeyondDepth_um) return std::nullopt;
  std::vector<double> depths_um, forces_uN, lowers_uN, uppers_uN;
  for (std::size_t i = 0; i <= end; ++i) {
    if (std::abs(points_[i].depth_um - depth_um) > kHalfWindow_um) continue;
    depths_um.push_back(points_[i].depth_um);
    forces_uN.push_back(points_[i].force_uN);
    lowers_uN.push_back(points_[i].lower_uN);
    uppers_uN.push_back(points_[i].upper_uN);
  }
  const auto slope = robust_slope(depths_um, forces_uN);
  if (!slope) return std::nullopt;
  const double lower = robust_slope(depths_um, lowers_uN)->value, upper = robust_slope(depths_um, uppers_uN)->value;
  const auto [least, most] = std::minmax({slope->value, lower, upper});
  return RobustSlope{.value = slope->value,
                     .lower = slope->value - std::hypot(slope->value - least, slope->value - slope->lower),
                     .upper = slope->value + std::hypot(most - slope->value, slope->upper - slope->value)};
}

}  // namespace pellucida
