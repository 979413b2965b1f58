#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// Where the ooplasm's material goes when its boundary deforms: a map between the disc at rest, in polar coordinates
/// (`ratio` of the way to the boundary, `angle` about the centre, 0 at the apex), and the deformed section.
/// Deep inside areas are kept, as in a fluid; at the boundary the material stays with the membrane. The deformed
/// boundary must be seen whole from the map's centre.
class OoplasmFlow {
 public:
  /// `boundary` (2 x n): the ooplasm's boundary in the frame of the section; `angle_rad` (n): rest angles of its
  /// points.
  void update(const Contour_um& boundary, const Eigen::VectorXd& angle_rad);

  struct Rest {
    float ratio, angle;
    float boundary_um;  ///< the boundary's distance from the centre in that direction, now
  };
  /// What lies at a place of the section now, relative to `center`. Also a little outside (ratio > 1).
  Rest rest_of(float x_um, float z_um) const noexcept;

  /// Where material at rest coordinates lies now, relative to `center`.
  Eigen::Vector2f place_of(float ratio, float angle) const noexcept;

  /// The map's centre in the frame of the section, um.
  const Eigen::Vector2d& center() const noexcept { return center_; }

 private:
  static constexpr int kCount = 2048;

  // By direction from the centre (atan2(x, z), from the apex on): the rest angle deep inside and at the membrane.
  struct Direction {
    float angle, membrane_angle, radius_um;
  };
  std::vector<Direction> directions_ = std::vector<Direction>(kCount + 1);
  // By rest angle: the direction deep inside and at the membrane.
  std::vector<float> direction_inside_ = std::vector<float>(kCount + 1);
  std::vector<float> direction_membrane_ = std::vector<float>(kCount + 1);
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();
};

}  // namespace pellucida
