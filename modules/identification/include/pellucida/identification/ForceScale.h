#pragma once
#include "pellucida/identification/MeasuredCurve.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What the profile's effective modulus must be multiplied by to meet a measurement. All forces go with it, the shape
/// doesn't.
struct ForceScale {
  double ratio = 1.0;
  double relative_sigma = 0.0;   ///< standard error of the ratio over the ratio
  double residual_rms_uN = 0.0;  ///< measured less scaled model
  int point_count = 0;
};

/// The scale that takes configuration 1 through one measured point. One point tells nothing of its own spread:
/// `assumed_relative_sigma` is handed through. Throws UsageError for a force or depth the model can't meet.
ForceScale scale_to_point(const CellProfile& profile, double force_uN, double indentation_um,
                          double assumed_relative_sigma);

/// The scale of least squares, s = sum F m / sum m^2 with F measured and m the model in configuration 1, and its
/// standard error sqrt(sum (F - s m)^2 / (n - 1) / sum m^2), which takes the points' errors for independent: a curve
/// that is bent otherwise than the model is less certain than that says. Throws UsageError when the curve is deeper
/// than the model reaches, NothingMeasuredError when the scale isn't above 0.
ForceScale scale_to_curve(const CellProfile& profile, const MeasuredCurve& measured);

/// Multiplies the effective modulus and takes over the uncertainty.
void apply(const ForceScale& scale, CellProfile& profile);

}  // namespace pellucida
