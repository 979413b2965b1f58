#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pellucida::contour {

/// Arithmetic of closed polygons. Points are columns (2 x n), the first is not repeated at the end, any one length
/// unit.

/// Index i of a closed contour with n points, wrapped into 0..n-1.
inline Eigen::Index wrap(Eigen::Index i, Eigen::Index n) noexcept {
  return ((i % n) + n) % n;
}

/// Shoelace area, sum of (x_i y_{i+1} - x_{i+1} y_i) / 2: positive when the angle grows from +x to +y. 0 below 3
/// points.
inline double signed_area(const Eigen::Matrix2Xd& points) noexcept {
  const Eigen::Index n = points.cols();
  double twice = 0.0;
  for (Eigen::Index i = 0; n >= 3 && i < n; ++i) {
    const Eigen::Index j = i + 1 == n ? 0 : i + 1;
    twice += points(0, i) * points(1, j) - points(0, j) * points(1, i);
  }
  return 0.5 * twice;
}

/// Perimeter, closing edge included.
inline double arc_length(const Eigen::Matrix2Xd& points) noexcept {
  const Eigen::Index n = points.cols();
  double length = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) length += (points.col(i + 1 == n ? 0 : i + 1) - points.col(i)).norm();
  return length;
}

/// Centre of the enclosed area; the mean of the points where the area vanishes.
inline Eigen::Vector2d centroid(const Eigen::Matrix2Xd& points) {
  const Eigen::Index n = points.cols();
  if (n == 0) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d mean = points.rowwise().mean();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double twice = 0.0;
  // About the mean, so that far-away contours lose no digits.
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = points.col(i) - mean;
    const Eigen::Vector2d b = points.col(i + 1 == n ? 0 : i + 1) - mean;
    const double cross = a.x() * b.y() - b.x() * a.y();
    sum += cross * (a + b);
    twice += cross;
  }
  if (std::abs(twice) < 1e-12) return mean;
  return mean + sum / (3.0 * twice);
}

/// `count` points equally spaced along the perimeter, starting at arc length `start` after the first point (wrapped).
/// Same orientation. Needs 2 points or more and a perimeter above 0; otherwise the input comes back.
/// Into `result` (2 x count), which must not be `points`; no allocation when the size stays.
inline void resample_into(const Eigen::Matrix2Xd& points, Eigen::Index count, double start, Eigen::Matrix2Xd& result) {
  const Eigen::Index n = points.cols();
  const double total = arc_length(points);
  if (n < 2 || count < 1 || !(total > 0.0)) {
    result = points;
    return;
  }
  result.resize(2, count);
  start = std::fmod(std::fmod(start, total) + total, total);
  Eigen::Index edge = 0;
  double before = 0.0;
  double length = (points.col(1) - points.col(0)).norm();
  Eigen::Index turns = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double s = start + total * static_cast<double>(k) / static_cast<double>(count);
    // Walk to the edge that holds arc length s; a contour is walked at most twice.
    while (before + length < s && turns < 2 * n) {
      before += length;
      ++turns;
      edge = edge + 1 == n ? 0 : edge + 1;
      length = (points.col(edge + 1 == n ? 0 : edge + 1) - points.col(edge)).norm();
    }
    const double t = length > 0.0 ? std::clamp((s - before) / length, 0.0, 1.0) : 0.0;
    result.col(k) = (1.0 - t) * points.col(edge) + t * points.col(edge + 1 == n ? 0 : edge + 1);
  }
}

/// The same as a new matrix.
inline Eigen::Matrix2Xd resample(const Eigen::Matrix2Xd& points, Eigen::Index count, double start = 0.0) {
  Eigen::Matrix2Xd result;
  resample_into(points, count, start, result);
  return result;
}

/// The same closed contour with positive signed area.
inline Eigen::Matrix2Xd positively_oriented(const Eigen::Matrix2Xd& points) {
  if (signed_area(points) >= 0.0) return points;
  return points.rowwise().reverse();
}

/// Outward unit normals of a positively oriented contour, from central differences, into `normals` (2 x n). No
/// allocation when the size stays.
inline void outward_normals(const Eigen::Matrix2Xd& points, Eigen::Matrix2Xd& normals) {
  const Eigen::Index n = points.cols();
  normals.resize(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d t = points.col(i + 1 == n ? 0 : i + 1) - points.col(i == 0 ? n - 1 : i - 1);
    const double length = t.norm();
    normals.col(i) = length > 0.0 ? Eigen::Vector2d(t.y() / length, -t.x() / length) : Eigen::Vector2d(0.0, 0.0);
  }
}

/// The same as a new matrix.
inline Eigen::Matrix2Xd outward_normals(const Eigen::Matrix2Xd& points) {
  Eigen::Matrix2Xd normals;
  outward_normals(points, normals);
  return normals;
}

/// As resample(), but along cubic arcs through the points (tangents from the parabola through three of them) instead of
/// chords, which cut each bend by spacing^2 / (8 radius); into `result` (2 x count), which must not be `points`. Equal
/// spacing is that of the chords. No allocation when the size stays.
inline void resample_smooth(const Eigen::Matrix2Xd& points, Eigen::Index count, double start,
                            Eigen::Matrix2Xd& result) {
  const Eigen::Index n = points.cols();
  const double total = arc_length(points);
  if (n < 3 || count < 1 || !(total > 0.0)) {
    result = points;
    return;
  }
  result.resize(2, count);
  const auto place = [&](Eigen::Index i) { return points.col(i < 0 ? i + n : i >= n ? i - n : i); };
  const auto tangent = [&](Eigen::Index i) -> Eigen::Vector2d {
    const Eigen::Vector2d before = place(i) - place(i - 1), after = place(i + 1) - place(i);
    const double a = before.norm(), b = after.norm();
    if (!(a > 0.0) || !(b > 0.0)) return Eigen::Vector2d::Zero();
    return (after * (a / b) + before * (b / a)) / (a + b);
  };
  start = std::fmod(std::fmod(start, total) + total, total);
  Eigen::Index edge = 0, turns = 0;
  double before = 0.0, length = (place(1) - place(0)).norm();
  Eigen::Vector2d leave = tangent(0), arrive = tangent(1);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double s = start + total * static_cast<double>(k) / static_cast<double>(count);
    while (before + length < s && turns < 2 * n) {
      before += length;
      ++turns;
      edge = edge + 1 == n ? 0 : edge + 1;
      length = (place(edge + 1) - place(edge)).norm();
      leave = arrive;
      arrive = tangent(edge + 1 == n ? 0 : edge + 1);
    }
    const double t = length > 0.0 ? std::clamp((s - before) / length, 0.0, 1.0) : 0.0;
    const double r = 1.0 - t;
    result.col(k) = (1.0 + 2.0 * t) * r * r * place(edge) + t * t * (3.0 - 2.0 * t) * place(edge + 1) +
                    length * (t * r * r * leave - t * t * r * arrive);
  }
}

/// Arc length of the crossing of the contour with the ray from `origin` along unit `direction`: of the crossing
/// farthest out. -1 where the ray meets nothing.
inline double ray_crossing_arc(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& origin,
                               const Eigen::Vector2d& direction) {
  const Eigen::Index n = points.cols();
  double best_distance = -1.0, best_arc = -1.0, before = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = points.col(i) - origin;
    const Eigen::Vector2d b = points.col(i + 1 == n ? 0 : i + 1) - origin;
    const double sa = direction.x() * a.y() - direction.y() * a.x();
    const double sb = direction.x() * b.y() - direction.y() * b.x();
    const double length = (b - a).norm();
    if ((sa <= 0.0) != (sb <= 0.0)) {
      const double t = sa / (sa - sb);
      const double distance = direction.dot(a + t * (b - a));
      if (distance > 0.0 && distance > best_distance) {
        best_distance = distance;
        best_arc = before + t * length;
      }
    }
    before += length;
  }
  return best_arc;
}

/// Whether `point` lies inside the closed contour (even-odd rule).
inline bool contains(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& point) noexcept {
  const Eigen::Index n = points.cols();
  bool inside = false;
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) {
    const bool crosses = (points(1, i) > point.y()) != (points(1, j) > point.y());
    if (crosses &&
        point.x() <
            (points(0, j) - points(0, i)) * (point.y() - points(1, i)) / (points(1, j) - points(1, i)) + points(0, i)) {
      inside = !inside;
    }
  }
  return inside;
}

/// Whether the boxes of the edges from `a` to `b` and from `c` to `d` meet; edges whose boxes don't can't cross.
inline bool do_boxes_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                          const Eigen::Vector2d& d) noexcept {
  return std::max(a.x(), b.x()) >= std::min(c.x(), d.x()) && std::max(c.x(), d.x()) >= std::min(a.x(), b.x()) &&
         std::max(a.y(), b.y()) >= std::min(c.y(), d.y()) && std::max(c.y(), d.y()) >= std::min(a.y(), b.y());
}

/// Whether two of the contour's edges that are no neighbours cross. Cost O(n^2), no allocation.
inline bool self_intersects(const Eigen::Matrix2Xd& points) noexcept {
  const Eigen::Index n = points.cols();
  const auto side = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = points.col(i), b = points.col(i + 1 == n ? 0 : i + 1);
    for (Eigen::Index j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Eigen::Vector2d c = points.col(j), d = points.col(j + 1 == n ? 0 : j + 1);
      if (!do_boxes_meet(a, b, c, d)) continue;
      if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return true;
    }
  }
  return false;
}

/// Takes the loops out of a closed contour that crosses itself: the points of each loop (the shorter way round) move
/// to where it crosses. Returns the number of loops. Cost O(n^2).
inline int untie(Eigen::Matrix2Xd& points) noexcept {
  const Eigen::Index n = points.cols();
  int loops = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 2; k <= n / 2; ++k) {
      const Eigen::Index j = wrap(i + k, n);
      const Eigen::Vector2d a = points.col(i), b = points.col(wrap(i + 1, n));
      const Eigen::Vector2d c = points.col(j), d = points.col(wrap(j + 1, n));
      if (!do_boxes_meet(a, b, c, d)) continue;
      const Eigen::Vector2d e = b - a, f = d - c;
      const double cross = e.x() * f.y() - e.y() * f.x();
      if (cross == 0.0) continue;
      const double s = ((c - a).x() * f.y() - (c - a).y() * f.x()) / cross;
      const double t = ((c - a).x() * e.y() - (c - a).y() * e.x()) / cross;
      if (s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0) continue;
      const Eigen::Vector2d crossing = a + s * e;
      for (Eigen::Index l = 1; l <= k; ++l) points.col(wrap(i + l, n)) = crossing;
      ++loops;
      break;
    }
  }
  return loops;
}

/// Distance from `point` to the nearest place on the closed polygon.
inline double distance_to(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& point) noexcept {
  const Eigen::Index n = points.cols();
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d a = points.col(i), e = points.col(i + 1 == n ? 0 : i + 1) - points.col(i);
    const double squared = e.squaredNorm();
    const double t = squared > 0.0 ? std::clamp(e.dot(point - a) / squared, 0.0, 1.0) : 0.0;
    best = std::min(best, (point - a - t * e).squaredNorm());
  }
  return std::sqrt(best);
}

/// A circle. Lengths are in the unit of the points that it was fitted to, px in this module.
struct Circle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
  double inlier_ratio = 0.0;  ///< share of the points within the tolerance
  double residual = 0.0;      ///< RMS distance of those points from the circle
};

/// Robust circle through points (2 x n), by repeated least squares (Coope: |p|^2 = 2 c.p + k) with weights that fall
/// off beyond `tolerance`. `weights` (n) may be empty. Fewer than 3 points give radius 0.
inline Circle fit_circle(const Eigen::Matrix2Xd& points, double tolerance, const Eigen::VectorXd& weights = {}) {
  Circle circle;
  const Eigen::Index n = points.cols();
  if (n < 3) return circle;
  const Eigen::Vector2d shift = points.rowwise().mean();
  // Start from medians, which a dimple of a quarter of the outline does not move much.
  std::vector<double> distances(static_cast<std::size_t>(n));
  circle.center = shift;
  for (int round = 0; round < 12; ++round) {
    if (round == 0) {
      for (Eigen::Index i = 0; i < n; ++i) distances[static_cast<std::size_t>(i)] = (points.col(i) - shift).norm();
      std::nth_element(distances.begin(), distances.begin() + n / 2, distances.end());
      circle.radius = distances[static_cast<std::size_t>(n / 2)];
    }
    // Tolerance shrinks from generous to the one asked for.
    const double scale = std::max(tolerance, circle.radius * 0.25 / (1 << std::min(round, 10)));
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d p = points.col(i) - shift;
      const double off = ((points.col(i) - circle.center).norm() - circle.radius) / scale;
      double w = 1.0 / (1.0 + off * off);
      w *= w;
      if (weights.size() == n) w *= weights[i];
      const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
      normal += w * row * row.transpose();
      right += w * row * p.squaredNorm();
    }
    const Eigen::Vector3d x = normal.inverse() * right;
    if (!x.allFinite()) break;
    const double radius_squared = x[2] + x.head<2>().squaredNorm();
    if (!(radius_squared > 0.0)) break;
    circle.center = shift + x.head<2>();
    circle.radius = std::sqrt(radius_squared);
  }
  Eigen::Index inliers = 0;
  double squares = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double off = (points.col(i) - circle.center).norm() - circle.radius;
    if (std::abs(off) > tolerance) continue;
    ++inliers;
    squares += off * off;
  }
  circle.inlier_ratio = static_cast<double>(inliers) / static_cast<double>(n);
  circle.residual = inliers > 0 ? std::sqrt(squares / static_cast<double>(inliers)) : 0.0;
  return circle;
}

}  // namespace pellucida::contour
