#pragma once
#include <Eigen/Core>
#include <functional>
#include <stop_token>
#include <vector>

#include "pellucida/fem/CurveOutcome.h"
#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

class Indenter;

/// One way to push the needle, and the force it takes at each depth: what the constants are fitted to.
struct ReferenceCurve {
  int configuration = 0;          ///< 1..4; 0: none of the paper's
  double holder_angle_rad = 0.0;  ///< between the axes of needle and holder, 0 to pi/2
  double offset_um = 0.0;         ///< of the needle beside the cell's centre
  Eigen::VectorXd depth_um;       ///< (n) rising, the first 0
  Eigen::VectorXd force_uN;       ///< (n) along the push, at the profile's effective modulus
  int node_count = 0;             ///< of the finite-element mesh
  double largest_stretch = 1.0;   ///< largest principal stretch of the middle surface, at any depth
  CurveOutcome outcome = CurveOutcome::kComplete;
};

struct ReferenceOptions {
  double max_indentation_um = 0.0;  ///< > 0, at most 1.4 R
  double step_um = 2.0;             ///< > 0
  double edge_length_ratio = 1.0;   ///< of the finite-element mesh, see ShellOptions
  int threads = 0;                  ///< 0: as many as the machine has cores
};

/// The paper's four configurations by the finite-element shell, of the profile's geometry and bonds at its effective
/// modulus; each in a thread. `progress` is called with their joint share done, 0 to 1, from any of the threads, one
/// call at a time. A curve that ends early, and all of them after a cancellation, hold what was reached. Throws
/// UsageError for a geometry the shell does not accept.
std::vector<ReferenceCurve> compute_reference_curves(const CellProfile& profile, const ReferenceOptions& options,
                                                     const std::function<void(double share)>& progress = {},
                                                     const std::stop_token& cancel = {});

/// One such curve, of any angle (0 to pi/2) and offset, in the calling thread.
ReferenceCurve compute_reference_curve(const CellProfile& profile, double holder_angle_rad, double offset_um,
                                       const ReferenceOptions& options,
                                       const std::function<void(double share)>& progress = {},
                                       const std::stop_token& cancel = {});

/// The difference between the model and a reference.
struct CurveError {
  double largest_ratio = 0.0;          ///< largest |model - reference| / reference from `from_um` on
  double largest_of_peak_ratio = 0.0;  ///< largest |model - reference| over the reference's last force, everywhere
  double rms_of_peak_ratio = 0.0;      ///< root mean square of that
  double from_um = 0.0;
  double to_um = 0.0;     ///< deepest point compared
  bool complete = false;  ///< the model found its equilibrium at every depth
};

/// The forces of `indenter`, which is at rest, at the reference's depths up to `to_um`, and how far they are off.
/// `force_uN` (may be null) takes its forces, as many as it reached.
CurveError compare_with_reference(Indenter& indenter, const ReferenceCurve& reference, double from_um, double to_um,
                                  Eigen::VectorXd* force_uN = nullptr);
/// The same of the profile's springs alone.
CurveError compare_with_reference(const CellProfile& profile, const ReferenceCurve& reference, double from_um,
                                  double to_um, Eigen::VectorXd* force_uN = nullptr);

}  // namespace pellucida
