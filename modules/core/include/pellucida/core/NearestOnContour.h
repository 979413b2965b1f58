#pragma once
#include <Eigen/Core>
#include <limits>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// The closed contour's point nearest to a place, and the index of the segment it lies on.
struct Nearest {
  Eigen::Vector2d place_um = Eigen::Vector2d::Zero();
  double distance_um = std::numeric_limits<double>::infinity();
  Eigen::Index segment = 0;
};
Nearest nearest_on(const Contour_um& contour, const Eigen::Vector2d& place_um);

/// How far from `place_um` along its outward `normal` (unit) the contour lies; NaN where none is near, or one that is
/// hardly seen.
double offset_of(const MembraneContour& contour, const Eigen::Vector2d& place_um, const Eigen::Vector2d& normal);

/// The median standard deviation along a contour, um; 0: not estimated.
double usual_sigma_um(const MembraneContour& contour);

}  // namespace pellucida
