#pragma once
#include <Eigen/Core>
#include <optional>

namespace pellucida {

/// An arrow at a view's edge that shows the way to something beyond it.
struct EdgePointer {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();          ///< the arrow's head, inside the view by the margin
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, towards the thing
  double beyond = 0.0;  ///< how far the thing is from the view's edge, along the way to it, >= 0
};

/// The arrow to `place` in a view of `width` by `height` from (0, 0), on the line from its middle; nothing while the
/// place is inside. All lengths in one unit; `margin` less than half the smaller side.
std::optional<EdgePointer> edge_pointer(const Eigen::Vector2d& place, double width, double height, double margin);

}  // namespace pellucida
