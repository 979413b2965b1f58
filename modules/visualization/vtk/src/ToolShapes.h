#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// The needle of a scene: the observation's, else read back from the tools' outline (tip = its first point, direction
/// from the outline's middle to the tip, width at the tip from the points near it). Nothing when the scene shows no
/// needle.
std::optional<NeedlePose> needle_of(const Scene& scene);

/// The holding pipette of a scene: the observation's, else nothing (an outline alone does not show the mouth).
std::optional<HolderPose> holder_of(const Scene& scene);

/// A point of a tool's profile: `along_um` from the origin against the pushing direction, `radius_um` >= 0.
struct ProfilePoint {
  double along_um = 0.0;
  double radius_um = 0.0;
};

/// Half-width of the needle along its shaft, from the outline: starts at the tip, never gets thinner, at most
/// `length_um` long.
std::vector<ProfilePoint> needle_profile(const NeedlePose& needle, double length_um);

/// Wall of a holding pipette, from the outer wall round the rounded lip into the bore; `length_um` long.
std::vector<ProfilePoint> holder_profile(const HolderPose& holder, double length_um);

/// A profile revolved about the line through `origin_um` (in the image plane) along `direction` (unit): quads with
/// outward normals, in frame W. `along_um` counts in `direction`.
vtkSmartPointer<vtkPolyData> revolve_profile(const std::vector<ProfilePoint>& profile, const Eigen::Vector2d& origin_um,
                                             const Eigen::Vector2d& direction);

}  // namespace pellucida
