#pragma once
#include <Eigen/Core>
#include <string>

#include "pellucida/core/Expected.h"
#include "pellucida/core/Observation.h"
#include "pellucida/reconstruction/ClosedMesh.h"

namespace pellucida {

/// How finely a contour is revolved.
struct RevolveOptions {
  double step_deg = 10.0;  ///< angle between meridians; 360 / step_deg is a whole number >= 3 (the paper: 30 and 60)
  int meridian_point_count = 49;    ///< points from pole to pole, both included; >= 5
  double pole_density_ratio = 0.4;  ///< spacing at the needle's pole over the mean spacing, in (0, 1]; 1 = uniform
};

/// Throws UsageError, with value and limit, when an option is out of its range.
void validate(const RevolveOptions& options);

/// A contour revolved about the symmetry axis (paper, section II: "applying a rotation operator to the membrane's
/// contours").
///
/// The two halves of a real contour are never quite alike. The meridian at angle phi is their blend,
///   p(phi) = (1 + cos phi)/2 p_positive + (1 - cos phi)/2 p_negative,
/// so that the image plane cuts the mesh exactly in the contour seen, and a symmetric contour gives a surface of
/// revolution.
///
/// Node order, the same in every frame: node 0 is the needle-side pole; then rings from that pole on, each with its
/// nodes at phi = 0, step, 2 step, ...; the last node is the far pole. phi turns from t = (-axis.y, axis.x) in the
/// image plane to +z.
struct RevolvedMesh {
  ClosedMesh mesh;
  Eigen::Matrix3Xd rest_direction;  ///< (3 x n) unit, from the cell centre to where the node lies on the cell at rest
};

/// `center_um`, `axis`: as in `cut_meridians`, whose failures are passed on. `options` are valid.
expected<RevolvedMesh, std::string> revolve(const Contour_um& contour_um, const Eigen::Vector2d& center_um,
                                            const Eigen::Vector2d& axis, const RevolveOptions& options);

}  // namespace pellucida
