#include "Dimple.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"

namespace pellucida {
namespace {

// Of the radius: how far to either side of the needle's line a dimple is looked at; how far out its rim may bulge.
constexpr double kReach_ratio = 0.8, kRim_ratio = 1.05;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// An outline as seen from a needle's tip: along the needle, and across it.
struct FromTip {
  const Eigen::Matrix2Xd& outline;
  const Eigen::Vector2d& tip;
  const Eigen::Vector2d& direction;

  Eigen::Index size() const { return outline.cols(); }
  Eigen::Vector2d at(Eigen::Index i) const { return outline.col(contour::wrap(i, size())) - tip; }
  double along(Eigen::Index i) const { return at(i).dot(direction); }
  double across(Eigen::Index i) const { return cross(direction, at(i)); }
};

// Where the needle's line first meets the outline: behind point `before`, -1 if nowhere.
struct Meeting {
  Eigen::Index before = -1;
  double along_px = 0.0;

  explicit Meeting(const FromTip& seen) {
    for (Eigen::Index i = 0; i < seen.size(); ++i) {
      const double at = seen.across(i), next = seen.across(i + 1);
      if ((at < 0.0) == (next < 0.0)) continue;
      const double along = seen.along(i) + at / (at - next) * (seen.along(i + 1) - seen.along(i));
      if (before >= 0 && along >= along_px) continue;
      before = i;
      along_px = along;
    }
  }
  // The first point that way, -1 or 1.
  Eigen::Index first(int way) const { return way < 0 ? before : before + 1; }
};

}  // namespace

double Dimple::worst_px() const noexcept {
  return std::max({folded_px, notched_px, short_px, raised_px});
}

Dimple Dimple::of(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center, double radius_px,
                  const Eigen::Vector2d& tip, const Eigen::Vector2d& direction) {
  Dimple dimple;
  const FromTip seen{outline, tip, direction};
  const Meeting middle(seen);
  if (middle.before < 0) return dimple;
  dimple.short_px = std::max(0.0, -middle.along_px);
  for (const int way : {-1, 1}) {
    const Eigen::Index first = middle.first(way);
    const double side = seen.across(first) < 0.0 ? -1.0 : 1.0;
    double farthest = 0.0, before = middle.along_px, back = 0.0, rim = middle.along_px;
    for (Eigen::Index k = 0; k < seen.size() / 3; ++k) {
      const Eigen::Index i = first + way * k;
      const double across = side * seen.across(i), along = seen.along(i);
      if (across > kReach_ratio * radius_px) break;
      farthest = std::max(farthest, across);
      back += std::max(0.0, before - along);
      before = along;
      rim = std::min(rim, along);
      dimple.folded_px = std::max(dimple.folded_px, farthest - across);
      dimple.notched_px = std::max(dimple.notched_px, back - (middle.along_px - rim));
      dimple.raised_px = std::max(dimple.raised_px, (seen.at(i) + tip - center).norm() - kRim_ratio * radius_px);
    }
  }
  return dimple;
}

Eigen::Matrix2Xd with_smooth_dimple(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& tip,
                                    const Eigen::Vector2d& direction, double reach_px) {
  Eigen::Matrix2Xd result = outline;
  const FromTip seen{outline, tip, direction};
  const Meeting middle(seen);
  if (middle.before < 0) return result;
  for (const int way : {-1, 1}) {
    const Eigen::Index first = middle.first(way);
    const double side = seen.across(first) < 0.0 ? -1.0 : 1.0;
    Eigen::Index count = 0;  // of the points up to the last within reach
    for (Eigen::Index k = 0; k < seen.size() / 3; ++k)
      if (side * seen.across(first + way * k) < reach_px) count = k + 1;
    // A cubic from the tip, where it runs across the needle, to the outline's own way beyond.
    const Eigen::Vector2d end = seen.at(first + way * count);
    const double length = end.norm();
    const Eigen::Vector2d leaves = side * length * Eigen::Vector2d(-direction.y(), direction.x());
    const Eigen::Vector2d arrives =
        length * (seen.at(first + way * (count + 2)) - seen.at(first + way * count)).normalized();
    for (Eigen::Index k = 0; k < count; ++k) {
      const double t = (static_cast<double>(k) + 0.5) / (static_cast<double>(count) + 0.5), u = 1.0 - t;
      result.col(contour::wrap(first + way * k, seen.size())) =
          tip + t * u * u * leaves + t * t * (3.0 - 2.0 * t) * end - t * t * u * arrives;
    }
  }
  return result;
}

}  // namespace pellucida
