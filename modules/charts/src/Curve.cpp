#include "pellucida/charts/Curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pellucida {

void Curve::add(double x_value, double y_value, double lower_value, double upper_value) {
  x.push_back(x_value);
  y.push_back(y_value);
  lower.push_back(std::isfinite(lower_value) ? lower_value : y_value);
  upper.push_back(std::isfinite(upper_value) ? upper_value : y_value);
}

void Curve::add_gap() {
  if (empty() || std::isnan(y.back())) return;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  add(x.back(), nan, nan, nan);
}

Curve thinned(const Curve& curve, std::size_t most) {
  if (curve.size() <= most) return curve;
  // Three points remain of each stretch.
  const std::size_t stretch = 3 * curve.size() / std::max<std::size_t>(most, 3) + 1;
  Curve thin;
  for (std::size_t i = 0; i < curve.size();) {
    if (std::isnan(curve.y[i])) {
      thin.add_gap();
      ++i;
      continue;
    }
    std::size_t end = i;
    std::array<std::size_t, 3> kept{i, i, i};
    for (; end < curve.size() && end < i + stretch && !std::isnan(curve.y[end]); ++end) {
      if (curve.y[end] < curve.y[kept[1]]) kept[1] = end;
      if (curve.y[end] > curve.y[kept[2]]) kept[2] = end;
    }
    std::sort(kept.begin(), kept.end());
    const auto last = std::unique(kept.begin(), kept.end());
    for (auto k = kept.begin(); k != last; ++k) thin.add(curve.x[*k], curve.y[*k], curve.lower[*k], curve.upper[*k]);
    i = end;
  }
  return thin;
}

bool is_ascending(const Curve& curve) {
  return std::is_sorted(curve.x.begin(), curve.x.end());
}

std::vector<std::size_t> way_in(std::span<const double> x) {
  std::vector<std::size_t> kept;
  double farthest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > farthest)) continue;
    farthest = x[i];
    kept.push_back(i);
  }
  return kept;
}

Curve band_of_way_in(const Curve& curve) {
  Curve band;
  for (const std::size_t i : way_in(curve.x)) {
    if (!std::isnan(curve.y[i])) band.add(curve.x[i], curve.y[i], curve.lower[i], curve.upper[i]);
  }
  return band;
}

}  // namespace pellucida
