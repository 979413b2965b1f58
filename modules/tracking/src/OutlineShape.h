#pragma once
#include <Eigen/Core>

#include "ContourMath.h"

namespace pellucida {

/// How far an outline, (2 x n) px, lies beside the circle fitted to its undeformed part, as shares of the radius.
class OutlineShape {
 public:
  OutlineShape(const Eigen::Matrix2Xd& points, const contour::Circle& circle);

  /// 1 for an outline most of which lies on its circle, as a cell's does even with a dimple in it; down to 0.3 for one
  /// that lies beside it all round: half its points are 4 % of the radius off where doubt begins.
  double roundness() const noexcept;
  /// Whether a cell may look so: with a deep dimple most of the outline lies on the circle, and an oval one is nowhere
  /// far from it. The end of a wide pipette is neither.
  bool may_be_cell() const noexcept;

 private:
  double median_ = 0.0, most_ = 0.0;  // half, and nine tenths, of the points are nearer
};

}  // namespace pellucida
