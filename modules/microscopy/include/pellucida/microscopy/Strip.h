#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace pellucida {

/// The pixels about a tool: columns [first, last] of a row whose lateral distance to an axis is at most `reach`, and
/// whose place along it is at least `begin`; all lengths in px.
struct Strip {
  Eigen::Vector2d origin, along, across;
  double reach, begin;

  bool columns(int y, int width, int& first, int& last) const {
    double low = 0, high = width - 1;
    // A bound a * x + b in [min, max].
    auto cut = [&](double a, double b, double min, double max) {
      if (std::abs(a) < 1e-9) {
        if (b < min || b > max) high = -1;
        return;
      }
      double x0 = (min - b) / a, x1 = (max - b) / a;
      if (x0 > x1) std::swap(x0, x1);
      low = std::max(low, x0);
      high = std::min(high, x1);
    };
    const double dy = y - origin.y();
    cut(across.x(), dy * across.y() - origin.x() * across.x(), -reach, reach);
    cut(along.x(), dy * along.y() - origin.x() * along.x(), begin, 1e9);
    first = static_cast<int>(std::ceil(low));
    last = static_cast<int>(std::floor(high));
    return first <= last;
  }
};

}  // namespace pellucida
