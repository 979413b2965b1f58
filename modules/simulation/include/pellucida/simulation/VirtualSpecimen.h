#pragma once
#include <Eigen/Core>
#include <optional>

#include "pellucida/core/Observation.h"
#include "pellucida/simulation/CellReference.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida {

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
  double tip_depth_um = 0.0;           ///< of the needle, as given
  double membrane_depth_um = 0.0;      ///< of the outer membrane's contact point: the indentation
  double contact_force_uN = 0.0;
  double pressure_Pa = 0.0;
  CellReference::Section section;
};

/// The cell under a needle: a function of the needle's depth and of what happened before (puncture). Knows nothing of
/// who moves the needle. Its mechanics come from finite elements alone.
///
/// Free: the tip is outside the resting membrane. Contact: the membrane follows the tip. Punctured: from the moment the
/// depth passes the scenario's puncture depth; the force is 0 at once and the membrane returns exponentially to the
/// residual depth about the needle, or with the needle where that is less deep. Free again, and whole, once the tip has
/// left.
class VirtualSpecimen {
 public:
  /// Throws as CellReference::load; UsageError when the scenario's depth goes beyond the reference (which is the limit:
  /// the indentation when there is no puncture, the puncture's depth when there is).
  explicit VirtualSpecimen(const Scenario& scenario);

  /// The state at `time_s` with the tip `tip_depth_um` past the resting membrane. Times must not go back; see `reset`.
  SpecimenState advance(double tip_depth_um, double time_s);
  /// Forgets the puncture.
  void reset() noexcept {
    puncture_time_s_ = -1.0;
    last_time_s_.reset();
  }

  /// The pose in the image without drift.
  SpecimenPose pose() const noexcept { return pose_; }
  /// Unit vector from the cell's centre to the holder, frame W.
  Eigen::Vector2d holder_direction() const noexcept { return holder_direction_; }
  const CellReference& reference() const noexcept { return reference_; }
  double size_scale() const noexcept { return scale_; }
  double outer_radius_um() const noexcept { return scale_ * reference_.outer_radius_um(); }
  double inner_radius_um() const noexcept { return scale_ * reference_.inner_radius_um(); }

 private:
  CellReference reference_;
  Scenario::Puncture puncture_;
  double scale_ = 1.0;
  SpecimenPose pose_;
  Eigen::Vector2d holder_direction_ = Eigen::Vector2d::UnitX();
  double puncture_time_s_ = -1.0;      // < 0: the membrane is whole
  std::optional<double> last_time_s_;  // of the last call
  double last_depth_um_ = 0.0;         // of the tip then
};

/// Radius of the dimple's mouth across the axis: half the distance between the crests on both sides of the apex; 0
/// without a dimple, also while the top is flattened but has no crests yet (the first 4 to 5 um).
/// `outer` in the frame of the section.
double dimple_radius_um(const Contour_um& outer);

/// Volume inside a section, each half revolved about the axis and the two averaged (Pappus): exact for a surface of
/// revolution. um^3.
double revolved_volume_um3(const Contour_um& section);

}  // namespace pellucida
