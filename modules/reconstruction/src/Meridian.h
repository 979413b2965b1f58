#pragma once
#include <Eigen/Core>
#include <string>

#include "pellucida/core/Expected.h"
#include "pellucida/core/Observation.h"

namespace pellucida {

/// The two halves of a closed contour, cut where the symmetry axis crosses it, sampled at the same fractions of their
/// arc length. Column j of both has run the same share of the way from the needle-side pole (j = 0) to the far pole.
struct MeridianPair {
  Eigen::VectorXd arc_fraction;  ///< (m) 0..1, increasing
  Eigen::Matrix2Xd positive;     ///< (2 x m) rows: height along the axis, distance from it (um); the side of +t
  Eigen::Matrix2Xd negative;     ///< the side of -t, distances positive as well
};

/// Arc fractions that are denser at the needle's pole: s(u) = g u + (1 - g) u^2 at u = 0, 1/(m-1), ..., 1; g = 1 is
/// uniform.
Eigen::VectorXd graded_fractions(int count, double pole_density_ratio);

/// Cuts `contour_um` (closed, 2 x n, n >= 8) at the axis through `center_um` along the unit vector `axis` (towards the
/// needle). The side of +t is that of t = (-axis.y, axis.x). The result depends neither on the contour's start point
/// nor on its sense. A dimple may be deeper than the centre: the needle-side pole is then its bottom, at a height below
/// 0. Fails, with the reason, when the axis does not cross the contour, the contour lies wholly to one side of the
/// centre, or it has a number that is not finite.
expected<MeridianPair, std::string> cut_meridians(const Contour_um& contour_um, const Eigen::Vector2d& center_um,
                                                  const Eigen::Vector2d& axis, const Eigen::VectorXd& arc_fraction);

}  // namespace pellucida
