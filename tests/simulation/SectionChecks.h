#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "pellucida/core/Observation.h"

namespace pellucida::test {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// How many pairs of a closed polygon's sides cross.
inline int crossing_count(const Contour_um& polygon) {
  const Eigen::Index n = polygon.cols();
  auto at = [&](Eigen::Index i) -> Eigen::Vector2d { return polygon.col(i % n); };
  auto side_of = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return cross(b - a, p - a) > 0;
  };
  int count = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (side_of(at(i), at(i + 1), at(j)) != side_of(at(i), at(i + 1), at(j + 1)) &&
          side_of(at(j), at(j + 1), at(i)) != side_of(at(j), at(j + 1), at(i + 1)))
        ++count;
    }
  return count;
}

inline bool inside(const Contour_um& polygon, const Eigen::Vector2d& point) {
  bool result = false;
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++)
    if ((polygon(1, i) > point.y()) != (polygon(1, j) > point.y()) &&
        point.x() < (polygon(0, j) - polygon(0, i)) * (point.y() - polygon(1, i)) / (polygon(1, j) - polygon(1, i)) +
                        polygon(0, i))
      result = !result;
  return result;
}

/// Distance of a point to a closed polygon.
inline double distance_to(const Contour_um& polygon, const Eigen::Vector2d& point) {
  double best = std::numeric_limits<double>::infinity();
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = polygon.col(i), way = polygon.col((i + 1) % n) - a;
    const double t = std::clamp((point - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (point - a - t * way).norm());
  }
  return best;
}

inline double signed_area(const Contour_um& polygon) {
  double twice = 0;
  const Eigen::Index n = polygon.cols();
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) twice += cross(polygon.col(j), polygon.col(i));
  return twice / 2;
}

}  // namespace pellucida::test
