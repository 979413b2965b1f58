#pragma once
#include <Eigen/Core>

#include "pellucida/simulation/Scenario.h"
#include "pellucida/simulation/VirtualSpecimen.h"

namespace pellucida {

/// Motion of the stage (or the camera) since the first frame: cell, holder and needle turn about the image's centre,
/// then move.
struct StagePose {
  Eigen::Vector2d shift_um = Eigen::Vector2d::Zero();
  double rotation_rad = 0.0;                           ///< +x towards +y
  Eigen::Vector2d pivot_um = Eigen::Vector2d::Zero();  ///< the image's centre

  /// A position and a direction of the first frame, now. Without a rotation no digit of them changes.
  Eigen::Vector2d place(const Eigen::Vector2d& point_um) const;
  Eigen::Vector2d turn(const Eigen::Vector2d& direction) const;
  /// The same for a whole pose.
  SpecimenPose place(const SpecimenPose& pose) const;
};

/// The scenario's drift, rotation and knocks at a time.
StagePose stage_pose(const Scenario& scenario, double time_s);

/// The lamp's light at a time, relative to the scenario's background: its step and its flicker.
double lamp_ratio(const Scenario::Lamp& lamp, double time_s) noexcept;

}  // namespace pellucida
