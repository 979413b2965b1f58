#pragma once
#include <Eigen/Core>
#include <memory>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/SpecimenContact.h"

namespace pellucida {

class SectionField;

/// Where the cell lies in the image and how it is turned.
struct SpecimenPose {
  Eigen::Vector2d center_um = Eigen::Vector2d::Zero();  ///< frame W
  Eigen::Vector2d axis = Eigen::Vector2d::UnitX();    ///< unit, from the cell's centre to the needle: z of the section
  Eigen::Vector2d across = Eigen::Vector2d::UnitY();  ///< unit, at right angles to it: x of the section

  Eigen::Vector2d to_image(const Eigen::Vector2d& section_point) const {
    return center_um + section_point.x() * across + section_point.y() * axis;
  }
};

/// The specimen at one moment, in the frame of the section (CellReference).
struct SpecimenState {
  CellState state = CellState::kFree;  ///< free, contact or punctured
  double tip_depth_um = 0.0;           ///< of the needle past the resting membrane, as given
  double tip_offset_um = 0.0;          ///< of the needle's line from the cell's centre, towards +x of the section
  double tip_out_of_plane_um = 0.0;    ///< of the tip from the image plane, into the scene
  double membrane_depth_um = 0.0;      ///< of the outer membrane's contact point: the indentation
  double contact_force_uN = 0.0;       ///< of the needle on the cell, along its push
  double lateral_force_uN = 0.0;       ///< across it, towards +x of the section
  double pressure_Pa = 0.0;
  bool in_range = true;  ///< the tip is within the finite-element tables
  CellReference::Section section;
  double apex_angle_rad = 0.0;  ///< rest angle of the material under the needle: the section's point n / 2
  SpecimenMoment moment;        ///< puncture and droplets
};

/// The cell under a needle: a function of the needle's position and of what happened before (puncture,
/// SpecimenContact), independent of what moves the needle. Its mechanics come from finite elements alone.
class VirtualSpecimen {
 public:
  /// Throws as CellReference::load; UsageError when the scenario's depth exceeds the reference (the limit applies to
  /// the indentation if there is no puncture, to the puncture's depth if there is).
  explicit VirtualSpecimen(const Scenario& scenario);
  ~VirtualSpecimen();
  VirtualSpecimen(VirtualSpecimen&&) noexcept;
  VirtualSpecimen& operator=(VirtualSpecimen&&) noexcept;

  /// The straight push: the tip `tip_depth_um` past the resting membrane on the configuration's own line. Its lateral
  /// force is that of the finite elements, whose tip sticks. Times must not go back; see `reset`.
  SpecimenState advance(double tip_depth_um, double time_s);
  /// A freely moved needle of constant direction: the tip at a position of frame W. `expelled_pL` is the total it has
  /// expelled so far.
  SpecimenState advance(const PlainVector3& tip_um, double time_s, double expelled_pL = 0.0);
  /// The state of a contact that was advanced elsewhere, by a 1 kHz thread's own copy of `contact()`.
  SpecimenState show(const SpecimenMoment& moment) const;
  /// A new cell: forgets puncture and droplets.
  void reset() noexcept { contact_.reset(); }

  /// A 1 kHz thread takes a copy of it.
  const SpecimenContact& contact() const noexcept { return contact_; }
  /// The force at any position, for an intact membrane.
  const SpecimenForce& force() const noexcept { return contact_.force(); }

  /// The pose in the image without drift.
  SpecimenPose pose() const noexcept { return pose_; }
  /// Unit vector from the cell's centre to the holder, frame W.
  Eigen::Vector2d holder_direction() const noexcept { return holder_direction_; }
  const CellReference& reference() const noexcept;
  double size_scale() const noexcept { return scale_; }
  double outer_radius_um() const noexcept { return scale_ * reference().outer_radius_um(); }
  double inner_radius_um() const noexcept { return scale_ * reference().inner_radius_um(); }
  /// Of the configuration's own line from the centre, um.
  double offset_um() const noexcept { return scale_ * reference().offset_um(); }
  /// z of the resting membrane, in the section's frame, where a needle `offset_um` from the centre touches it.
  double rest_z_um(double offset_um) const noexcept;

 private:
  std::unique_ptr<const SectionField> sections_;
  double scale_ = 1.0;
  double stiffness_ratio_ = 1.0;
  SpecimenPose pose_;
  Eigen::Vector2d holder_direction_ = Eigen::Vector2d::UnitX();
  SpecimenContact contact_;
};

/// Radius of the dimple's mouth across the axis: half the distance between the crests on both sides of the apex; 0
/// without a dimple, also while the top is flattened but has no crests yet (the first 4 to 5 um).
/// `outer` in the frame of the section.
double dimple_radius_um(const Contour_um& outer);

/// Volume inside a section, each half revolved about the axis and the two averaged (Pappus): exact for a surface of
/// revolution. um^3.
double revolved_volume_um3(const Contour_um& section);

}  // namespace pellucida
