#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/CellProfile.h"
#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/HingeTerm.h"
#include "pellucida/membrane/SpringTerm.h"
#include "pellucida/membrane/TriangleMesh.h"
#include "pellucida/membrane/VolumeTerm.h"

namespace pellucida {

/// The cell and how it is held, in the cell frame C: origin at the cell's centre, +z towards the contact point at rest.
struct MembraneSetup {
  double mid_radius_um = 0.0;
  double thickness_um = 0.0;
  Eigen::Vector3d push = -Eigen::Vector3d::UnitZ();    ///< unit, direction of the needle's push
  Eigen::Vector3d holder = -Eigen::Vector3d::UnitZ();  ///< unit, from the centre to the holder
  bool keeps_volume = true;                            ///< false: the liquid leaves freely; no volume term, no pressure
};

/// A needle whose axis makes the angle `holder_angle_rad` with the holder's (0: opposite it, pi/2: across it) and runs
/// `offset_um` beside the cell's centre, towards the side a turned holder lies on where above 0. The contact point is
/// where the axis meets the outer surface. Throws UsageError unless the angle is in 0..pi/2 and the offset within 0.8
/// of the outer radius, or when tip and holder would overlap.
MembraneSetup setup_for_needle(const CellProfile& profile, double holder_angle_rad, double offset_um);

/// The paper's four tested configurations, in the cell frame. Throws UsageError for a number outside 1..4. 1 needle
/// opposite the holder; 2 at 45 degrees; 3 at 90 degrees; 4 parallel to the holder's axis, `offset_um` beside it.
MembraneSetup setup_for_configuration(const CellProfile& profile, int configuration, double offset_um = 10.0);

/// How much each node belongs to each region, 0 to 1, summing to 1: the tip's over the holder's over the body, with
/// smooth borders. Constants of the regions are mixed in these shares.
struct RegionShares {
  Eigen::VectorXd tip, body, holder;  ///< (n)
};
RegionShares region_shares(const TriangleMesh& rest, const CellProfile& profile, const Eigen::Vector3d& holder);

/// The mass-spring-damper membrane: one triangulated sphere with X-shaped connectors, hinges, constant volume, needle
/// and holder attached elastically. The tools touch the outer surface: their radii in the profile are measured there
/// and brought to the middle surface, which is the sphere, along the normal, as in the finite-element reference. Energy
/// U = U_springs + U_hinges + U_volume + U_tip + U_holder.
class MembraneModel {
 public:
  MembraneModel(const CellProfile& profile, const MembraneSetup& setup);

  MembraneModel(const MembraneModel&) = delete;
  MembraneModel& operator=(const MembraneModel&) = delete;

  /// As adapted to its geometry.
  const CellProfile& profile() const noexcept { return profile_; }
  const TriangleMesh& rest() const noexcept { return rest_; }
  const MembraneSetup& setup() const noexcept { return setup_; }
  /// The sum of this model's terms, for a solver. Further terms may be added to it.
  EnergySum& energy() noexcept { return energy_; }
  const EnergySum& energy() const noexcept { return energy_; }

  /// Moves the holder; regions and holder weights follow.
  void set_holder(const Eigen::Vector3d& direction);
  /// Moves the needle `depth_um` along its push.
  void set_depth(double depth_um) { tip_.set_displacement(depth_um * setup_.push); }
  /// Moves the needle anywhere from where it first touched.
  void set_tip_displacement(const Eigen::Vector3d& displacement_um) { tip_.set_displacement(displacement_um); }

  /// The membrane's own elastic force on each node, uN (3 x n): that of springs and hinges.
  Eigen::Matrix3Xd elastic_force_uN(const Eigen::Matrix3Xd& x_um) const;
  /// What is left of all forces on each node, uN (3 x n), the elastic one being known: 0 in equilibrium. Without terms
  /// that were added to the sum.
  Eigen::Matrix3Xd residual_uN(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& elastic_uN) const;

  const SpringTerm& springs() const noexcept { return springs_; }
  const HingeTerm& hinges() const noexcept { return hinges_; }
  const VolumeTerm& volume() const noexcept { return volume_; }
  const AttachmentTerm& tip() const noexcept { return tip_; }
  const AttachmentTerm& holder() const noexcept { return holder_; }

  /// E h, uN/um: the scale of all forces.
  double force_scale_uN_per_um() const noexcept { return energy_.force_scale_uN_per_um(); }

 private:
  CellProfile profile_;
  MembraneSetup setup_;
  TriangleMesh rest_;
  std::vector<TrianglePair> pairs_;
  SpringTerm springs_;
  HingeTerm hinges_;
  VolumeTerm volume_;
  AttachmentTerm tip_;
  AttachmentTerm holder_;
  EnergySum energy_;
};

}  // namespace pellucida
