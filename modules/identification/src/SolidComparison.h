#pragma once
#include <optional>
#include <stop_token>

#include "pellucida/identification/ReferenceCurves.h"

namespace pellucida {

/// Depths compared begin here, um: below, the noise of any depth hides the model's error.
inline constexpr double kCompareFrom_um = 4.0;
/// What a `ProfileError` calls the solid.
inline constexpr const char* kSolidReference = "axisymmetric solid finite elements, scaled to the anchor";

/// The solid's curve of the profile's own cell, configuration 1, in the form of the shells'; nothing where it couldn't
/// be solved down to `to_um`.
std::optional<ReferenceCurve> solid_curve(const CellProfile& profile, double to_um, double step_um,
                                          const std::stop_token& cancel);

/// What `errors` says of the solid, anew: the profile's own cell as it is measured (`geometry_factor` included) against
/// the solid, both through the puncture point. Nothing changes where either couldn't be solved that deep.
void record_solid_error(CellProfile& profile, const std::stop_token& cancel);

}  // namespace pellucida
