#pragma once
#include <functional>

#include "pellucida/mechanics/ScaleMeasurement.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// The modulus that a suction and its tongue give.
struct AspiratedModulus {
  double modulus_kPa = 0.0;
  double relative_sigma = 0.0;          ///< of its logarithm
  double half_space_modulus_kPa = 0.0;  ///< by Theret's formula for a half-space, which no thin zona is
};

/// Young's modulus of the zona from an aspiration, by the finite elements of the aspirated shell
/// (`AspirationReference`; some seconds). Radius, and thickness where it is not given, are the profile's. The
/// uncertainty is that of suction, tongue, mouth and thickness, by the slopes of the elements' result, and 5 % for
/// elements and law. Throws UsageError when a number is missing or out of range, or no equilibrium with that tongue is
/// found.
AspiratedModulus aspirated_modulus(const ScaleMeasurement& aspiration, const CellProfile& profile);

/// The measurement with what its aspiration gives filled in: modulus, sigma, and the modulus of a solid zona that
/// passes the profile's puncture point over the profile's effective modulus (the springs follow a thin shell, which is
/// stiffer than a solid). A push, or an aspiration that has its modulus, stays as it is. Throws as `aspirated_modulus`.
ScaleMeasurement with_modulus(const ScaleMeasurement& measurement, const CellProfile& profile);

}  // namespace pellucida
