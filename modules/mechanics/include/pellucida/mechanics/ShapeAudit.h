#pragma once
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "pellucida/core/NeedleContact.h"
#include "pellucida/core/Observation.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// What the contour shows besides its depth, in the section visible in the image.
struct ShapeAudit {
  static constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

  /// RMS over the section of n . (y - x): the contour's middle line y against the model's section x, along its normal.
  double residual_rms_um = kNotMeasured;
  /// The part of it that the contour's own noise explains.
  double noise_um = kNotMeasured;
  /// Mean of n . (y - x) over the dimple, where the needle pushes: > 0 where the membrane lies farther out than the
  /// model, i.e. has not followed.
  double dimple_residual_um = kNotMeasured;
  /// Half the difference between the contour's left and right of the needle's line, RMS: what a surface of revolution
  /// about that line cannot show.
  double asymmetry_um = kNotMeasured;
  /// The part of it that the model, which knows where the holder is, doesn't show either.
  double unexplained_asymmetry_um = kNotMeasured;
};

/// Compares the tracked contours with the model's section. Keeps its memory from frame to frame. One thread at a time.
class ShapeAuditor {
 public:
  /// A model at rest, frame C (z towards the contact point, y out of the image plane): finds the nodes of the section
  /// y = 0.
  void set_model(const TriangleMesh& rest);

  /// Of one frame. `x_um` (3 x n) the model's nodes in frame C; `rotation_WC`, `center_um` place it in W;
  /// `thickness_um` between the contours at rest. Not measured when fewer than half of the section's nodes have a
  /// contour near them.
  ShapeAudit audit(const Observation& observation, const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3d& rotation_WC,
                   const Eigen::Vector3d& center_um, double thickness_um);

  /// After `audit`: by node of the section, its index, rest angle from the contact point (rad, -pi..pi, rising), and
  /// n . (y - x) (um; NaN where no contour was seen).
  const std::vector<int>& nodes() const noexcept { return nodes_; }
  const std::vector<double>& rest_angle_rad() const noexcept { return angle_rad_; }
  const std::vector<double>& residual_um() const noexcept { return residual_um_; }

 private:
  double asymmetry(const Observation& observation, const Eigen::Matrix3d& rotation_WC,
                   const Eigen::Vector3d& center_um) const;

  std::vector<int> nodes_;
  std::vector<double> angle_rad_;
  std::vector<int> mirror_;  // the node of the opposite angle
  std::vector<double> residual_um_;
  std::vector<Eigen::Vector2d> section_um_, normal_;
};

}  // namespace pellucida
