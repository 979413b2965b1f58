#pragma once
#include <Eigen/Core>

namespace pellucida {

/// How a closed outline runs beside a needle's tip that pushes it in: through the tip, then on either side away from
/// the needle's line and back along it up to the rim, never to and fro, never out of the cell at rest. By how much it
/// does not, px, each >= 0.
struct Dimple {
  double folded_px = 0.0;   ///< runs back towards the needle's line
  double notched_px = 0.0;  ///< runs back along it once more, beside the way up to the rim
  double short_px = 0.0;    ///< on the needle's line, ends before the tip
  double raised_px = 0.0;   ///< lies outside of where a pushed cell's rim bulges to

  /// `outline`: 2 x n, px, n >= 12; `center` and `radius_px`: of the cell at rest; `direction`: unit, shaft to tip.
  static Dimple of(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center, double radius_px,
                   const Eigen::Vector2d& tip, const Eigen::Vector2d& direction);

  double worst_px() const noexcept;
};

/// The outline with its part within `reach_px` of the needle's line replaced by a smooth dimple that ends on the tip;
/// as it is where the line does not meet it.
Eigen::Matrix2Xd with_smooth_dimple(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& tip,
                                    const Eigen::Vector2d& direction, double reach_px);

}  // namespace pellucida
