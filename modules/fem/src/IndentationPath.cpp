#include "IndentationPath.h"

#include <algorithm>
#include <string>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// In terms of the radius: no solution goes farther; a step that fails is halved down to the shortest; the tip may go
/// so deep; no node moves farther in one iteration.
constexpr double kLongestStep = 0.04, kShortestStep = 0.0005, kDeepest = 1.4, kFarthestMove = 0.08;

}  // namespace

std::string_view to_string(CurveOutcome outcome) noexcept {
  switch (outcome) {
    case CurveOutcome::kComplete:
      return "complete";
    case CurveOutcome::kCancelled:
      return "cancelled";
    case CurveOutcome::kNotConverged:
      return "not converged";
  }
  return "unknown";
}

IndentationPath::IndentationPath(EnergySum& energy, AttachmentTerm& tip, const Eigen::Matrix3Xd& rest_um,
                                 double radius_um, int max_iterations)
    : tip_(tip), rest_um_(rest_um), radius_um_(radius_um), solver_(energy) {
  options_.max_iterations = max_iterations;
  options_.max_step_um = kFarthestMove * radius_um;
  // How the gradient changes with the tip's way: through its bond alone.
  pull_ = Eigen::Matrix3Xd::Zero(3, rest_um.cols());
  for (std::size_t k = 0; k < tip_.nodes().size(); ++k) pull_(2, tip_.nodes()[k]) = -tip_.weights_uN_per_um()[k];
}

IndentationPath::End IndentationPath::run(double max_indentation_um, double step_um, const Arrived& arrived,
                                          const std::stop_token& cancel) {
  if (!(step_um > 0.0 && step_um <= max_indentation_um)) {
    throw UsageError("indentation: the step must be above 0 um and at most the largest depth");
  }
  if (max_indentation_um > kDeepest * radius_um_) {
    throw UsageError("indentation: at most 1.4 radii, " + std::to_string(kDeepest * radius_um_) + " um");
  }
  x_um_ = rest_um_;
  tangent_ = Eigen::Matrix3Xd::Zero(3, x_um_.cols());
  depth_um_ = 0.0;
  tip_.set_displacement(Eigen::Vector3d::Zero());

  std::vector<double> depths;
  for (int k = 0; k * step_um < max_indentation_um - 1e-9 * step_um; ++k) depths.push_back(k * step_um);
  depths.push_back(max_indentation_um);
  for (const double depth : depths) {
    SolveReport report;
    const CurveOutcome outcome = advance_to(depth, cancel, report);
    if (outcome != CurveOutcome::kComplete) {
      return {outcome, outcome == CurveOutcome::kNotConverged ? depth : 0.0, report};
    }
    arrived(depth_um_, x_um_, report);
  }
  return {};
}

CurveOutcome IndentationPath::advance_to(double depth_um, const std::stop_token& cancel, SolveReport& total) {
  double longest = kLongestStep * radius_um_;
  do {
    if (cancel.stop_requested()) return CurveOutcome::kCancelled;
    const double way = std::min(longest, depth_um - depth_um_);
    const double next = way < depth_um - depth_um_ ? depth_um_ + way : depth_um;
    Eigen::Matrix3Xd x = x_um_ + (next - depth_um_) * tangent_;
    tip_.set_displacement({0.0, 0.0, -next});
    const SolveReport report = solver_.solve(x, options_);
    total.status = report.status;
    total.iterations += report.iterations;
    total.factorizations += report.factorizations;
    total.shifts += report.shifts;
    total.residual_uN = report.residual_uN;
    if (report.status == SolveStatus::kConverged) {
      x_um_ = x;
      depth_um_ = next;
      tangent_ = solver_.apply_inverse_hessian(x_um_, pull_, tangent_);
    } else {
      tip_.set_displacement({0.0, 0.0, -depth_um_});
      longest = 0.5 * way;
      if (longest < kShortestStep * radius_um_) return CurveOutcome::kNotConverged;
    }
  } while (depth_um_ < depth_um);
  return CurveOutcome::kComplete;
}

}  // namespace pellucida
