#pragma once

#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// Both ends of the 95 % interval of a normal distribution lie so many standard deviations from its mean.
inline constexpr double kSigmas95 = 1.96;

/// The uncertainties of a force: those of the picture (depth, shape, model, geometry), which differ between frames and
/// between pushes, and that of the scale, one unknown factor on all forces of a cell. Relative parts are standard
/// deviations of its logarithm, absolute ones of itself, uN.
struct ForceErrors {
  double depth_uN = 0.0;        ///< noise and bias of the depth times the tangent stiffness
  double shape_uN = 0.0;        ///< the contour's residual beyond what is usual, times the tangent stiffness
  double relaxation_uN = 0.0;   ///< from the spread of the arms, where the membrane relaxes
  double model_uN = 0.0;        ///< the profile's stated error, below the depths it was compared at
  double model_ratio = 0.0;     ///< the same at those depths
  double geometry_ratio = 0.0;  ///< radius, thickness, tools at rest
  /// How much more a wall bears that stiffens with strain: it counts upwards only.
  double stiffening_ratio = 0.0;
  double scale_ratio = 0.0;  ///< of this kind of cell; of this cell, once its own scale was measured

  double absolute_uN() const noexcept;
  double relative() const noexcept;
  /// All but the scale's: what the picture leaves open.
  ForceErrors of_picture() const noexcept;
  /// The scale's alone.
  ForceErrors of_scale() const noexcept;
};

/// A force with its interval, uN.
struct ForceInterval {
  double lower_uN = 0.0;
  double upper_uN = 0.0;
  double sigma_uN = 0.0;  ///< half the interval's width over 1.96
};

/// The 95 % interval about `force_uN` >= 0. The relative errors multiply (log-normal), so that the interval extends
/// further up than down; the absolute ones add; both are independent:
///   upper = F + sqrt((F (exp(z u) - 1))^2 + (z a)^2),  lower = F - sqrt((F (1 - exp(-z r)))^2 + (z a)^2),  z = 1.96,
/// with r the relative errors and u the same with the stiffening; lower at least 0.
ForceInterval interval_95(double force_uN, const ForceErrors& errors) noexcept;

/// The part of `errors` that the model itself brings, from the errors the profile lists. Each says: largest relative
/// error q from a depth on, and largest error in shares of the peak; taken as two standard deviations, the lesser of
/// the two counts. Below that depth nothing was compared: the error there is taken as large, in uN, as at it, which is
/// the absolute floor of a shallow force; `rest_stiffness_uN_per_um` says what force that is.
void add_model_errors(const CellProfile& profile, double force_uN, double rest_stiffness_uN_per_um,
                      ForceErrors& errors) noexcept;

}  // namespace pellucida
