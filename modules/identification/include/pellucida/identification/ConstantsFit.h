#pragma once
#include <functional>
#include <stop_token>
#include <vector>

#include "pellucida/identification/ReferenceCurves.h"
#include "pellucida/mechanics/CellProfile.h"

namespace pellucida {

/// What counts as one unit of error at a depth: the lesser of a share of the reference's force there and a share of its
/// last force; before `from_um` the share of the force there is twice as large.
struct FitOptions {
  double force_tolerance_ratio = 0.05;
  double peak_tolerance_ratio = 0.03;
  double from_um = 4.0;
  /// Where above 0: configuration 1 (or the first curve) must be met this close at this depth, since the force scale is
  /// anchored there.
  double anchor_um = 0.0;
  double anchor_tolerance_ratio = 0.01;
  /// Largest connector strain the constants must bear without turning soft: k1/k2 >= -1 / (3 e^2).
  double largest_strain = 1.0;
  int max_iterations = 40;  ///< of each of the two rounds
  int threads = 0;          ///< 0: as many as the machine has cores
};

struct FitReport {
  bool complete = false;    ///< false: cancelled, or no better constants were found from the start
  int evaluations = 0;      ///< of all curves together
  double worst_unit = 0.0;  ///< largest error in the units above; below 1 all tolerances are met
};

/// Constants to start a fit from: those of isotropic springs and plates, by region.
void set_starting_constants(CellProfile& profile);

/// Fits the nine constants of `profile` (K2, K1, g by region; the rest of it stays) to the curves: first least squares
/// of the errors in their units, then the sum of their sixth powers, which presses down the largest one. Levenberg and
/// Marquardt (Ceres) on log K2, K1/K2 (bounded), log g, with the exact Jacobian of CurveSensitivity; a weak pull to the
/// starting constants decides what the curves leave open. `progress` hears of every evaluation: how many there were and
/// the worst error so far. Same input, same constants. Throws UsageError when there is no curve or the model doesn't
/// bear the starting constants.
FitReport fit_constants(CellProfile& profile, const std::vector<ReferenceCurve>& curves, const FitOptions& options,
                        const std::function<void(int evaluations, double worst_unit)>& progress = {},
                        const std::stop_token& cancel = {});

}  // namespace pellucida
