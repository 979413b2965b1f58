#pragma once
#include <functional>
#include <stop_token>
#include <vector>

#include "pellucida/identification/ReferenceCurves.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// What counts as one unit of error at a depth: the lesser of a share of the reference's force there (before `from_um`
/// twice as large) and a share of its force at the anchor, or of that there where it is larger.
struct FitOptions {
  double force_tolerance_ratio = 0.05;
  double peak_tolerance_ratio = 0.027;
  double from_um = 4.0;
  /// The force scale is anchored to the first curve at its point nearest to this depth: errors are counted after model
  /// and reference are scaled to the same force there.
  double anchor_um = 0.0;
  /// The scale itself, model over reference at the anchor, stays within about this share of 1.
  double scale_tolerance_ratio = 0.02;
  /// Largest connector strain at which the constants must not turn soft: k1/k2 >= -1 / (3 e^2).
  double largest_strain = 1.0;
  int max_iterations = 12;  ///< of each of the three rounds
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
/// of the errors in their units; then, unless all are well within them, the sums of their fourth and of their eighth
/// powers, which push down the largest. Levenberg and Marquardt (Ceres) on log K2, K1/K2 (bounded), log g, with the
/// exact Jacobian of CurveSensitivity; a weak pull to the starting constants decides what the curves leave open.
/// `progress` is called at every evaluation with their number and the worst error so far. Same input, same constants.
/// Throws UsageError when there is no curve or the model is not stable with the starting constants.
FitReport fit_constants(CellProfile& profile, const std::vector<ReferenceCurve>& curves, const FitOptions& options,
                        const std::function<void(int evaluations, double worst_unit)>& progress = {},
                        const std::stop_token& cancel = {});

}  // namespace pellucida
