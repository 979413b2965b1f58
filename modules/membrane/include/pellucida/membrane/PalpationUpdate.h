#pragma once
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// This cell's own stiffness relative to the profile's: all forces scale with it. Log-normal: ln(ratio) is normal about
/// ln(`ratio`) with `relative_sigma`.
struct CellScale {
  double ratio = 1.0;           ///< > 0, the median
  double relative_sigma = 0.0;  ///< >= 0
  /// Measured by a push on this cell as it is seen: what sizes leave open is part of it.
  bool has_geometry = false;
  double push_depth_um = 0.0;  ///< of such pushes, their mean; 0 without one
};

/// An independent measurement made beforehand: a small push of known force, or of a known rise of the force with depth.
/// Exactly one of the two is above 0.
struct Palpation {
  double known_force_uN = 0.0;             ///< along the push
  double known_stiffness_uN_per_um = 0.0;  ///< tangent stiffness there
  double indentation_um = 0.0;             ///< where; > 0
  double indentation_sigma_um = 0.2;       ///< >= 0
  double relative_sigma = 0.05;            ///< of the known force or stiffness; > 0
};

/// Throws UsageError unless the numbers are as `Palpation` states.
void validate(const Palpation& palpation);

/// The scale of a cell before it is measured: the profile's, with the uncertainty of the kind's mean and the spread of
/// its single cells.
CellScale scale_before(const CellProfile& profile) noexcept;

/// Bayes' rule for the log-normal scale. With s = ln(ratio), the palpation measures y = ln(known / model) with the
/// variance r^2 + (k sd / F)^2 + m^2: known value, depth (slope k of the model's value F), model. Then
///   1/v' = 1/v + 1/w,  s' = v' (s/v + y/w).
/// `model_value` > 0 and its slope by depth: the profile's force (or stiffness) at the palpation's depth.
CellScale update_scale(const CellScale& before, const Palpation& palpation, double model_value,
                       double model_slope_per_um, double model_relative_sigma) noexcept;

/// One depth of a cell's risk.
struct PunctureRisk {
  double depth_um = 0.0;
  double force_uN = 0.0;     ///< expected there
  double probability = 0.0;  ///< that the membrane has given way by then
};

}  // namespace pellucida
