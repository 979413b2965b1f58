#pragma once
#include <Eigen/Core>
#include <functional>
#include <stop_token>

#include "pellucida/fem/CurveOutcome.h"
#include "pellucida/membrane/AttachmentTerm.h"
#include "pellucida/membrane/EquilibriumSolver.h"

namespace pellucida {

/// Follows a body's equilibria while a tool bonded to it moves along -z: each solution starts along the tangent of the
/// last one, a step that fails is halved. Works on terms that it doesn't own.
class IndentationPath {
 public:
  IndentationPath(EnergySum& energy, AttachmentTerm& tip, const Eigen::Matrix3Xd& rest_um, double radius_um,
                  int max_iterations);

  struct End {
    CurveOutcome outcome = CurveOutcome::kComplete;
    double failed_indentation_um = 0.0;  ///< when not converged
    SolveReport failure;
  };
  using Arrived = std::function<void(double depth_um, const Eigen::Matrix3Xd& x_um, const SolveReport& report)>;

  /// From rest to 0, step, 2 step, ... and the largest depth itself. `report` sums up all solutions since the depth
  /// before. Throws UsageError unless 0 < step <= max <= 1.4 radii.
  End run(double max_indentation_um, double step_um, const Arrived& arrived, const std::stop_token& cancel);

 private:
  CurveOutcome advance_to(double depth_um, const std::stop_token& cancel, SolveReport& total);

  AttachmentTerm& tip_;
  const Eigen::Matrix3Xd& rest_um_;
  double radius_um_;
  EquilibriumSolver solver_;
  SolveOptions options_;
  Eigen::Matrix3Xd pull_, x_um_, tangent_;
  double depth_um_ = 0.0;
};

}  // namespace pellucida
