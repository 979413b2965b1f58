#pragma once
#include <Eigen/Core>
#include <optional>

#include "pellucida/core/Observation.h"
#include "pellucida/mechanics/ShapeAudit.h"

namespace pellucida {

/// Where the cell, the contact point and the holder are, from frame to frame. The cell frame C in W: origin at the
/// cell's centre, z towards the contact point, y along W's z, so that the image plane is the plane y = 0. What isn't
/// seen is remembered. One thread at a time.
class CellPlacement {
 public:
  /// Precondition: the observation's centre is finite, its rest radius above 0.
  void update(const Observation& observation);
  void reset() { *this = CellPlacement{}; }
  void end_contact() noexcept { slipped_um_ = 0.0; }

  const Eigen::Matrix3d& rotation_WC() const noexcept { return rotation_WC_; }
  const Eigen::Vector3d& center_um() const noexcept { return center_um_; }  ///< frame W
  const Eigen::Vector3d& push() const noexcept { return push_; }      ///< unit, frame C: the way the needle pushes
  const Eigen::Vector3d& holder() const noexcept { return holder_; }  ///< unit, frame C, from the centre to the holder
  /// No holder seen so far: taken to lie where the needle pushes to.
  bool holder_assumed() const noexcept { return !holder_W_; }

  /// The needle enters the cell at the mouth of the holder that was seen, where none can get to: the two would overlap.
  /// Radii in um.
  bool enters_at_holder(double mouth_radius_um, double tip_radius_um, double cell_radius_um) const noexcept;

  /// Of the needle in the last frame that showed one.
  const NeedleContact& contact() const noexcept { return contact_; }
  /// Of the centre from the needle's line, um: followed while free, kept in contact; 0 where the line goes through the
  /// centre as far as a tracker can tell.
  double offset_um() const noexcept { return used_offset_um_; }
  /// How far the line has moved across itself since the contact began, um, smoothed.
  double slipped_um() const noexcept { return slipped_um_; }

 private:
  void follow_needle(const Observation& observation);
  void follow_holder(const Observation& observation);

  Eigen::Matrix3d rotation_WC_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d center_um_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d push_ = -Eigen::Vector3d::UnitZ(), holder_ = -Eigen::Vector3d::UnitZ();
  Eigen::Vector2d axis_ = Eigen::Vector2d::UnitX();
  std::optional<Eigen::Vector2d> holder_W_;
  NeedleContact contact_;
  std::optional<double> offset_um_;
  double used_offset_um_ = 0.0;
  double slipped_um_ = 0.0;
};

}  // namespace pellucida
