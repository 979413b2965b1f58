#pragma once
#include <cmath>
#include <numbers>

#include "pellucida/core/Observation.h"

namespace pellucida::test {

/// An ellipse of `count` points round `center_um`, semi-axes along and across the unit vector `axis`.
inline Contour_um ellipse(int count, const Eigen::Vector2d& center_um, const Eigen::Vector2d& axis, double along_um,
                          double across_um) {
  Contour_um contour_um(2, count);
  const Eigen::Vector2d side(-axis.y(), axis.x());
  for (int i = 0; i < count; ++i) {
    const double t = 2.0 * std::numbers::pi * (i + 0.37) / count;
    contour_um.col(i) = center_um + along_um * std::cos(t) * axis + across_um * std::sin(t) * side;
  }
  return contour_um;
}

}  // namespace pellucida::test
