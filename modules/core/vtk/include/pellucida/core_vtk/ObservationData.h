#pragma once
#include <vtkPolyData.h>

#include <optional>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// Names of the arrays that hold the numbers of an observation beside its curves, in the field data (a contract). One
/// tuple each, Float64; the components are named.
namespace array_name {
inline constexpr const char* kObservation = "observation";  ///< contours: state, confidence, rotation, indentation, ...
inline constexpr const char* kNeedlePose = "needle_pose";   ///< tools: only where a needle was seen
inline constexpr const char* kHolderPose = "holder_pose";   ///< tools: only where a holding pipette was seen
}  // namespace array_name

/// Rounds contours, outlines, and the sigma and confidence of their points to what a session's files hold of them
/// (32 bit, 3e-5 um at 500 um), so that the numbers computed live and those computed from a recording are the same
/// bits. All else is stored with 64 bit. Points without a confidence get 1.
void round_as_stored(Observation& observation);

/// Adds what the contours' curves, and the outlines of the tools, do not hold.
void add_observation(const Observation& observation, vtkPolyData* membranes);
void add_poses(const Observation& observation, vtkPolyData* tools);

/// The inverse of `make_membranes` and `make_tools` (SceneData.h): exactly the observation they were made of, if it was
/// rounded. Nothing where an array is missing, as in the sessions of earlier versions, or holds something else. `tools`
/// may be null: no tool was seen.
std::optional<Observation> read_observation(const vtkPolyData* membranes, const vtkPolyData* tools);

}  // namespace pellucida
