#include "pellucida/membrane/EquilibriumSolver.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "NewtonSystem.h"

namespace pellucida {
namespace {

/// A step's linear system is solved to this share of its right side at worst, at best to what converges in one go.
constexpr double kCoarsestStep = 3e-2;
constexpr double kFinestStep = 1e-5;
/// The Hessian is assembled anew where a step shrinks the residual less than this.
constexpr double kGoodShrinking = 0.1;
/// Conjugate gradients that take as long as a factorisation give way to one; those that take half as long have the next
/// solution begin with one. An iteration takes about a tenth of a factorisation.
constexpr int kMostIterations = 10;
constexpr int kManyIterations = 5;
/// Accuracy of the tangent; a compliance has its square.
constexpr double kTangentAccuracy = 3e-4;
/// A shape that needs a shifted Hessian in more iterations than this has given way. In cells of 25 um the equilibria
/// that were found, up to 1.4 radii deep and 1 and 9 um apart, took at most 54 shifts for one, of about ten an
/// iteration; in one of 39 um and one of about 61 um none. Where none was found, there were hundreds.
constexpr int kMostShiftedIterations = 12;
/// The energy's rounding, with terms that nearly cancel, may be so many times that of its sum.
constexpr double kRoundingPromise = 100.0;

Eigen::Map<const Eigen::VectorXd> flat(const Eigen::Matrix3Xd& m) {
  return {m.data(), m.size()};
}

double largest_column_norm(const Eigen::Matrix3Xd& m) {
  return std::sqrt(m.colwise().squaredNorm().maxCoeff());
}

}  // namespace

std::string_view to_string(SolveStatus status) noexcept {
  switch (status) {
    case SolveStatus::kConverged:
      return "converged";
    case SolveStatus::kIterationBudget:
      return "iteration budget spent";
    case SolveStatus::kTimeBudget:
      return "time budget spent";
    case SolveStatus::kNotPositiveDefinite:
      return "Hessian not positive definite, and no shift helps";
    case SolveStatus::kUnstable:
      return "the shape is unstable";
    case SolveStatus::kNoDescent:
      return "no descent";
    case SolveStatus::kNotFinite:
      return "not finite";
  }
  return "unknown";
}

class EquilibriumSolver::Impl {
 public:
  explicit Impl(EnergySum& sum) : energy(sum), system(sum) {}

  /// The direction down from `gradient` into `step`, H being assembled. False when no shift makes H positive definite.
  bool find_step(double accuracy, SolveReport& report) {
    step.setZero(gradient.size());
    ++report.iterations;
    is_exact = false;
    if (system.has_factor() && !wants_factor) {
      const int taken = system.conjugate_gradients(-flat(gradient), accuracy, kMostIterations, step);
      if (taken >= 0) {
        report.conjugate_gradient_iterations += taken;
        if (taken >= kManyIterations) wants_factor_next = true;
        return true;
      }
    }
    const int shifts = system.factorize();
    ++report.factorizations;
    if (shifts < 0) return false;
    report.shifts += shifts;
    wants_factor = wants_factor_next = false;
    system.apply_factor(-flat(gradient), step);
    is_exact = true;
    return true;
  }

  EnergySum& energy;
  NewtonSystem system;
  Eigen::Matrix3Xd gradient, candidate, candidate_gradient;
  Eigen::VectorXd step;
  bool is_exact = false;           ///< the step comes from a factorisation made for it
  bool wants_factor = false;       ///< conjugate gradients don't pay any more
  bool wants_factor_next = false;  ///< nor will they in the next solution
};

EquilibriumSolver::EquilibriumSolver(EnergySum& energy) : impl_(std::make_unique<Impl>(energy)) {}
EquilibriumSolver::~EquilibriumSolver() = default;

SolveReport EquilibriumSolver::solve(Eigen::Matrix3Xd& x_um, const SolveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Impl& my = *impl_;
  const EnergySum& sum = my.energy;
  const double tolerance_uN = options.tolerance_um * sum.force_scale_uN_per_um();
  SolveReport report;
  const auto ended = [&](SolveStatus status) {
    report.status = status;
    return report;
  };

  my.wants_factor = my.wants_factor || my.wants_factor_next;
  my.wants_factor_next = false;
  my.gradient.setZero(3, x_um.cols());
  double energy = sum.add(x_um, &my.gradient, nullptr);
  bool is_assembled = false;
  int shifted_iterations = 0;
  while (true) {
    report.residual_uN = largest_column_norm(my.gradient);
    if (!std::isfinite(energy) || !std::isfinite(report.residual_uN)) return ended(SolveStatus::kNotFinite);
    if (report.residual_uN <= tolerance_uN) return ended(SolveStatus::kConverged);
    if (report.iterations >= options.max_iterations) return ended(SolveStatus::kIterationBudget);
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.time_budget_s) {
      return ended(SolveStatus::kTimeBudget);
    }

    // The Hessian of this shape, or of one a good step away; the direction down.
    if (!is_assembled) {
      my.system.assemble(x_um);
      if (my.system.has_factor() && !my.wants_factor) my.system.refresh_rank_ones();
      is_assembled = true;
    }
    const double accuracy = std::clamp(0.03 * tolerance_uN / report.residual_uN, kFinestStep, kCoarsestStep);
    const int shifts_before = report.shifts;
    if (!my.find_step(accuracy, report)) return ended(SolveStatus::kNotPositiveDefinite);
    shifted_iterations += report.shifts > shifts_before ? 1 : 0;
    if (shifted_iterations > kMostShiftedIterations) return ended(SolveStatus::kUnstable);
    const Eigen::Map<const Eigen::Matrix3Xd> step(my.step.data(), 3, x_um.cols());
    const double slope = my.step.dot(flat(my.gradient));
    const double reach = std::sqrt(step.colwise().squaredNorm().maxCoeff());
    if (!std::isfinite(slope) || !std::isfinite(reach)) return ended(SolveStatus::kNotFinite);

    // Armijo, no node moving too far: accept when the energy drops by its share. Where all that the step promises is
    // within the energy's rounding, the gradient, which is more exact, decides: it must shrink.
    double length = std::min(1.0, options.max_step_um / std::max(reach, 1e-12));
    const double rounding = 1e-13 * (std::abs(energy) + sum.force_scale_uN_per_um());
    const bool promises_rounding = -slope < kRoundingPromise * rounding;
    bool accepted = false;
    for (int halving = 0; halving < (my.is_exact ? 30 : 2) && !accepted; ++halving) {
      my.candidate = x_um + length * step;
      my.candidate_gradient.setZero(3, x_um.cols());
      const double candidate_energy = sum.add(my.candidate, &my.candidate_gradient, nullptr);
      const bool is_lower = candidate_energy <= energy + 1e-4 * length * slope + rounding;
      const bool is_flatter = promises_rounding && candidate_energy <= energy + kRoundingPromise * rounding &&
                              largest_column_norm(my.candidate_gradient) < report.residual_uN;
      if (std::isfinite(candidate_energy) && (is_lower || is_flatter)) {
        accepted = true;
        energy = candidate_energy;
      } else {
        length *= 0.5;
      }
    }

    // A step that isn't taken: once more with a factorisation of its own.
    if (!accepted) {
      if (my.is_exact) return ended(SolveStatus::kNoDescent);
      my.wants_factor = true;
      is_assembled = false;
      continue;
    }
    is_assembled = largest_column_norm(my.candidate_gradient) < kGoodShrinking * report.residual_uN;
    x_um.swap(my.candidate);
    my.gradient.swap(my.candidate_gradient);
  }
}

LinearResponse EquilibriumSolver::respond(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& load,
                                          const Eigen::Matrix3Xd& guess) {
  Impl& my = *impl_;
  my.system.assemble(x_um);
  const Eigen::VectorXd right = flat(load);
  my.step = flat(guess);
  int taken = -1;
  if (my.system.has_factor() && !my.wants_factor) {
    taken = my.system.conjugate_gradients(right, kTangentAccuracy, kMostIterations, my.step);
    if (taken >= kManyIterations) my.wants_factor_next = true;
  }
  LinearResponse response;
  if (taken < 0) {
    if (my.system.factorize() < 0) return {Eigen::Matrix3Xd::Zero(3, x_um.cols()), 0.0};
    my.wants_factor = my.wants_factor_next = false;
    my.system.apply_factor(right, my.step);
  }
  response.displacement = Eigen::Map<const Eigen::Matrix3Xd>(my.step.data(), 3, x_um.cols());

  // 2 b.y - y.H y is stationary at y = H^-1 b: its error is the square of y's.
  Eigen::VectorXd product;
  my.system.multiply(my.step, product);
  response.compliance = 2.0 * right.dot(my.step) - my.step.dot(product);
  return response;
}

Eigen::Matrix3Xd EquilibriumSolver::apply_inverse_hessian(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& b,
                                                          const Eigen::Matrix3Xd& guess) {
  return respond(x_um, b, guess).displacement;
}

Eigen::Matrix3d EquilibriumSolver::tool_stiffness_uN_per_um(const AttachmentTerm& tool, const Eigen::Matrix3Xd& x_um) {
  // F = sum_i w_i (X_i + u - x_i), and H dx/du = w_i I: dF/du = sum_i w_i (I - dx_i/du).
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Matrix3Xd pull = Eigen::Matrix3Xd::Zero(3, x_um.cols());
    for (std::size_t k = 0; k < tool.nodes().size(); ++k) {
      pull(axis, tool.nodes()[k]) = tool.weights_uN_per_um()[k];
    }
    const Eigen::Matrix3Xd tangent = apply_inverse_hessian(x_um, pull, Eigen::Matrix3Xd::Zero(3, x_um.cols()));
    for (std::size_t k = 0; k < tool.nodes().size(); ++k) {
      stiffness.col(axis) += tool.weights_uN_per_um()[k] * (Eigen::Vector3d::Unit(axis) - tangent.col(tool.nodes()[k]));
    }
  }
  return stiffness;
}

}  // namespace pellucida
