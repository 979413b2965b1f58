#pragma once
#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/ReferenceGeometry.h"

namespace pellucida {

/// Finite-element results for one cell type in one configuration: force, pressure and the section's shape against the
/// indentation. Read from `resources/reference` (see the README there); never from the estimator's model.
///
/// Frame of the section: origin at the rest centre; x across, z along the axis towards the needle. The needle pushes
/// along -z on the line x = `offset_um`. The holder lies in the direction (sin phi, -cos phi), phi =
/// `holder_angle_rad`. Every contour has the same n material points, at the rest angles `angle_rad` (atan2(x, z) at
/// rest), rising; the middle one, n / 2, is the outer apex, where the needle touches.
class CellReference {
 public:
  /// `cell` a shipped one (`reference_cells`) or the path of others' tables without their ending (`films/specimen-7`
  /// for `films/specimen-7-1-force.csv`); `configuration` 1 (holder opposite the needle), 2 (45 degrees off), 3 (90), 4
  /// (as 1, the needle 10 um beside the holder's axis and parallel to it). In configuration 1 angle and offset are
  /// those of the geometry, if it has them. Throws UsageError when there is no such reference, InputError when a file
  /// is damaged.
  static CellReference load(std::string_view cell, int configuration);

  struct Section {
    Contour_um outer_um;  ///< (2 x n): x, z
    Contour_um inner_um;  ///< (2 x n)
  };
  /// Both membranes at a depth: a monotone cubic in depth for each material point. Below 0 the shape at rest; past the
  /// last step the shape there. The outer apex lies at z = apex_z_um() - depth.
  Section section(double indentation_um) const;
  /// Force of the needle on the cell along its push, uN, and excess pressure, Pa; 0 at and below depth 0.
  double force_uN(double indentation_um) const;
  /// The needle's force across its push, towards +x, of a tip that sticks to the membrane; 0 in configuration 1.
  double lateral_force_uN(double indentation_um) const;
  double pressure_Pa(double indentation_um) const;

  const Eigen::VectorXd& angle_rad() const noexcept { return angle_rad_; }         ///< (n) a turn about the apex's
  double outer_radius_um() const noexcept { return geometry_.outer_radius_um(); }  ///< at rest
  double inner_radius_um() const noexcept {
    return geometry_.middle_radius_um - 0.5 * geometry_.thickness_um;
  }                                            ///< at rest
  double max_indentation_um() const noexcept;  ///< the last step
  double holder_angle_rad() const noexcept { return holder_angle_rad_; }
  double offset_um() const noexcept { return offset_um_; }  ///< of the needle's line from the centre
  double apex_z_um() const noexcept { return apex_z_um_; }  ///< where that line meets the outer membrane at rest
  const ReferenceGeometry& geometry() const noexcept { return geometry_; }

 private:
  CellReference() = default;

  ReferenceGeometry geometry_;
  double holder_angle_rad_ = 0.0, offset_um_ = 0.0, apex_z_um_ = 0.0;
  Eigen::VectorXd angle_rad_;
  Eigen::VectorXd force_depth_um_, force_uN_, force_slope_, pressure_Pa_, pressure_slope_, lateral_uN_, lateral_slope_;
  Eigen::VectorXd depth_um_;                  // (s) steps of the profile
  std::vector<Eigen::VectorXd> shape_;        // (s) of (4 n): outer x, outer z, inner x, inner z
  std::vector<Eigen::VectorXd> shape_slope_;  // (s) derivatives by depth
};

/// Names of the shipped cells with a reference in all configurations.
std::vector<std::string> reference_cells();

}  // namespace pellucida
