#include "pellucida/visualization/EdgePointer.h"

#include <algorithm>
#include <limits>

namespace pellucida {

std::optional<EdgePointer> edge_pointer(const Eigen::Vector2d& place, double width, double height, double margin) {
  if (!place.allFinite() || !(width > 0.0) || !(height > 0.0)) return std::nullopt;
  if (place.x() >= 0.0 && place.x() <= width && place.y() >= 0.0 && place.y() <= height) return std::nullopt;
  const Eigen::Vector2d half(0.5 * width, 0.5 * height);
  const Eigen::Vector2d way = place - half;
  // Of the way from the middle to the place: until it meets a box that is smaller by `inset` on each side.
  const auto share_to = [&](double inset) {
    double share = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 2; ++k) {
      if (way[k] != 0.0) share = std::min(share, std::max(0.0, half[k] - inset) / std::abs(way[k]));
    }
    return share;
  };
  EdgePointer pointer;
  pointer.at = half + share_to(margin) * way;
  pointer.direction = way.normalized();
  pointer.beyond = (1.0 - share_to(0.0)) * way.norm();
  return pointer;
}

}  // namespace pellucida
