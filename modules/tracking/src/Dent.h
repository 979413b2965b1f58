#pragma once
#include <Eigen/Core>
#include <optional>

namespace pellucida {

/// Depth of the deepest local dent of a closed outline (2 x n px, n >= 24), as a share of its mean radius about
/// `center`, >= 0: inward from the ellipse through the rest of the outline, as a mean over a thirtieth of it (a
/// shallow, broad dent is taken for a quarter less, since it bends the ellipse). Within 60 degrees of `holder` (unit,
/// cell to holder) a pipette draws the membrane in, and nothing counts. An oval cell has no dent; one pushed over 0.08
/// of its radius by a needle has.
double dent_ratio(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center,
                  const std::optional<Eigen::Vector2d>& holder);

}  // namespace pellucida
