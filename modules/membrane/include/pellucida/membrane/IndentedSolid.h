#pragma once
#include <Eigen/Core>

namespace pellucida {

/// Logarithms of a cell's and its tools' sizes over the zona's outer radius: of its thickness, of the needle's tip
/// radius, of the holder's outer radius.
using LogSizes = Eigen::Vector3d;

/// The outer section of an incompressible solid shell full of liquid, under a needle opposite the holding pipette, and
/// the needle's force on it, as smooth functions of sizes and depth: fitted to solids of revolution computed for 640
/// geometries (`resources/shapes/indented_solid.py`, which prints what the fit leaves). Constant once made: for any
/// number of threads.
class IndentedSolid {
 public:
  /// The shipped one. Throws InputError when its file is damaged.
  static const IndentedSolid& shipped();

  /// Rest angles from the contact point of the section's points, rad, 0 to pi.
  const Eigen::VectorXd& angle_rad() const noexcept { return angle_rad_; }

  /// The half-section (x across, z towards the needle; 2 x n) over the outer radius, with the needle `depth_ratio`
  /// outer radii deep. Sizes and depth beyond the fitted range are taken as at its border.
  Eigen::Matrix2Xd section(const LogSizes& sizes, double depth_ratio) const;

  /// ln of the force over modulus and outer radius squared, up to a constant. Likewise at the border. Precondition: a
  /// depth above 0.
  double log_force(const LogSizes& sizes, double depth_ratio) const;
  /// ln of the liquid's pressure over the modulus, up to a constant; likewise.
  double log_pressure(const LogSizes& sizes, double depth_ratio) const;

  /// The sizes nearest to `sizes` within the fitted range.
  LogSizes within_range(const LogSizes& sizes) const;
  double deepest_ratio() const noexcept { return deepest_ratio_; }

 private:
  IndentedSolid() = default;
  Eigen::VectorXd basis(const LogSizes& sizes, double depth_ratio) const;

  LogSizes centre_, width_, lowest_, highest_;
  double depth_centre_ = 0.0, deepest_ratio_ = 0.0;
  Eigen::Matrix4Xi powers_;           // (4 x terms): of the three sizes, and the degree of the depth's polynomial
  Eigen::MatrixXd section_;           // (2 n x terms)
  Eigen::VectorXd force_, pressure_;  // (terms)
  Eigen::VectorXd angle_rad_;
  Eigen::Matrix2Xd rest_;
};

}  // namespace pellucida
