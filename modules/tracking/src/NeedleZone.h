#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucida {

/// px: half width of the needle's own dark edge, with its halo.
inline constexpr double kNeedleMargin = 2.5;

/// What the snakes need to know of the needle: where its own dark edges would be taken for a membrane.
struct NeedleZone {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();         ///< px
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< shaft to tip
  double tip_half_width = 0.0;                           ///< px
  double widening = 0.0;                                 ///< half width gained per px behind the tip
  bool touching = false;                                 ///< the membrane is known to wrap the tip
  double tip_sigma = 0.5;                                ///< px
  /// px: what is read farther from the outline than this, beside a tip that pushes, is another edge.
  double trust_px = std::numeric_limits<double>::infinity();
  bool is_shade = false;  ///< so far out of focus that membranes show through it and its edges are like none of theirs

  /// Whether `p` lies on the shaft or within `margin` px of its edges; nothing does while it is a mere shade.
  bool covers(const Eigen::Vector2d& p, double margin) const noexcept {
    if (is_shade) return false;
    const Eigen::Vector2d d = p - tip;
    const double behind = -d.dot(direction);
    if (behind < -margin) return false;
    const double across = std::abs(direction.x() * d.y() - direction.y() * d.x());
    return across < tip_half_width + widening * std::max(behind, 0.0) + margin;
  }
  /// True only if nothing from `p` to `q` is covered: both lie beyond the same edge.
  bool is_beside(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double margin) const noexcept {
    const Eigen::Vector2d across(-direction.y(), direction.x());
    const auto beyond = [&](const Eigen::Vector2d& point, double side) {
      const Eigen::Vector2d d = point - tip;
      return side * d.dot(across) > tip_half_width + widening * std::max(-d.dot(direction), 0.0) + margin;
    };
    return (beyond(p, 1.0) && beyond(q, 1.0)) || (beyond(p, -1.0) && beyond(q, -1.0));
  }
};

}  // namespace pellucida
