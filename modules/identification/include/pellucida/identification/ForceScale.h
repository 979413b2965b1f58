#pragma once
#include "pellucida/identification/MeasuredCurve.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// The factor on the profile's effective modulus that meets a measurement. All forces scale with it, the shape does
/// not.
struct ForceScale {
  double ratio = 1.0;
  double relative_sigma = 0.0;   ///< standard error of the ratio over the ratio
  double residual_rms_uN = 0.0;  ///< measured minus scaled model
  int point_count = 0;
};

/// The scale with which configuration 1 passes one measured point. One point carries no information on its spread:
/// `assumed_relative_sigma` is passed through. Throws UsageError for a force or depth the model can't meet.
ForceScale scale_to_point(const CellProfile& profile, double force_uN, double indentation_um,
                          double assumed_relative_sigma);

/// The scale of least squares, s = sum F m / sum m^2 with F measured and m the model in configuration 1, and its
/// standard error sqrt(sum (F - s m)^2 / (n - 1) / sum m^2), which assumes independent errors of the points: a curve
/// that bends differently from the model is less certain than that. Throws UsageError when the curve is deeper than the
/// model reaches, NothingMeasuredError when the scale isn't above 0.
ForceScale scale_to_curve(const CellProfile& profile, const MeasuredCurve& measured);

/// Multiplies the effective modulus and adopts the uncertainty.
void apply(const ForceScale& scale, CellProfile& profile);

}  // namespace pellucida
