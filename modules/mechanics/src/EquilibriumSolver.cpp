#include "pellucida/mechanics/EquilibriumSolver.h"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace pellucida {
namespace {

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
    case SolveStatus::kNoDescent:
      return "no descent";
    case SolveStatus::kNotFinite:
      return "not finite";
  }
  return "unknown";
}

class EquilibriumSolver::Impl {
 public:
  explicit Impl(MembraneModel& model)
      : hessian_(static_cast<int>(model.rest().points_um.cols()), model.coupled_nodes()) {
    model.bind(hessian_);
    factor_.analyzePattern(hessian_.sparse());
  }

  /// Energy, gradient and a positive definite factorisation at `x_um`; returns the number of shifts it took, -1 when
  /// none helps.
  int factorize(const MembraneModel& model, const Eigen::Matrix3Xd& x_um, double& energy, Eigen::Matrix3Xd& gradient) {
    gradient.setZero(3, x_um.cols());
    hessian_.set_zero();
    energy = model.add(x_um, &gradient, &hessian_);
    const Eigen::Matrix3Xd slope = model.volume().gradient_of_volume(x_um);
    volume_slope_ = flat(slope);
    rank_one_factor_ = model.volume().rank_one_factor();

    // Shift the diagonal until no direction goes down.
    double shift = 0.0;
    for (int shifts = 0; shifts < 24; ++shifts) {
      factor_.setShift(shift);
      factor_.factorize(hessian_.sparse());
      if (factor_.info() == Eigen::Success && is_positive_definite()) return shifts;
      shift = shift > 0.0 ? 4.0 * shift : 1e-3 * model.force_scale_uN_per_um();
    }
    return -1;
  }

  /// H^-1 b with H = S + c g g^T: S^-1 b - c S^-1 g (g.S^-1 b) / (1 + c g.S^-1 g).
  Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const {
    const Eigen::VectorXd direct = factor_.solve(b);
    return direct - factor_of_slope_ *
                        (rank_one_factor_ * volume_slope_.dot(direct) / (1.0 + rank_one_factor_ * slope_product_));
  }

 private:
  /// The signs of the pivots tell how many negative eigenvalues S has; H has one fewer when 1 + c g.S^-1 g < 0
  /// (Haynsworth's inertia additivity on the matrix bordered by g).
  bool is_positive_definite() {
    const auto pivots = factor_.vectorD();
    int negative = 0;
    for (Eigen::Index k = 0; k < pivots.size(); ++k) {
      if (!(pivots[k] > 0.0)) ++negative;
    }
    if (negative > 1) return false;
    factor_of_slope_ = factor_.solve(volume_slope_);
    slope_product_ = volume_slope_.dot(factor_of_slope_);
    const double along = 1.0 + rank_one_factor_ * slope_product_;
    return negative == 0 ? along > 0.0 : along < 0.0;
  }

  BlockMatrix hessian_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
  Eigen::VectorXd volume_slope_;     // grad V
  Eigen::VectorXd factor_of_slope_;  // S^-1 grad V
  double slope_product_ = 0.0;       // grad V . S^-1 grad V
  double rank_one_factor_ = 0.0;
};

EquilibriumSolver::EquilibriumSolver(MembraneModel& model) : impl_(std::make_unique<Impl>(model)) {}
EquilibriumSolver::~EquilibriumSolver() = default;

SolveReport EquilibriumSolver::solve(const MembraneModel& model, Eigen::Matrix3Xd& x_um, const SolveOptions& options) {
  SolveReport report;
  const double tolerance_uN = options.tolerance_um * model.force_scale_uN_per_um();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  Eigen::Matrix3Xd candidate, candidate_gradient;

  double energy = model.add(x_um, &gradient, nullptr);
  while (true) {
    report.residual_uN = largest_column_norm(gradient);
    if (!std::isfinite(energy) || !std::isfinite(report.residual_uN)) {
      report.status = SolveStatus::kNotFinite;
      return report;
    }
    if (report.residual_uN <= tolerance_uN) {
      report.status = SolveStatus::kConverged;
      return report;
    }
    if (report.iterations >= options.max_iterations) {
      report.status = SolveStatus::kIterationBudget;
      return report;
    }

    // Newton's direction, no node moving too far.
    const int shifts = impl_->factorize(model, x_um, energy, gradient);
    ++report.iterations;
    if (shifts < 0) {
      report.status = SolveStatus::kNoDescent;
      return report;
    }
    report.shifts += shifts;
    Eigen::VectorXd step = -impl_->apply_inverse(flat(gradient));
    const double slope = step.dot(flat(gradient));
    const double reach = largest_column_norm(Eigen::Map<const Eigen::Matrix3Xd>(step.data(), 3, x_um.cols()));
    if (!std::isfinite(slope) || !std::isfinite(reach)) {
      report.status = SolveStatus::kNotFinite;
      return report;
    }

    // Armijo: accept when the energy drops by its share, or when only rounding is left to argue about.
    double length = std::min(1.0, options.max_step_um / std::max(reach, 1e-12));
    const double rounding = 1e-13 * (std::abs(energy) + model.force_scale_uN_per_um());
    bool accepted = false;
    for (int halving = 0; halving < 30 && !accepted; ++halving) {
      candidate = x_um + length * Eigen::Map<const Eigen::Matrix3Xd>(step.data(), 3, x_um.cols());
      candidate_gradient.setZero(3, x_um.cols());
      const double candidate_energy = model.add(candidate, &candidate_gradient, nullptr);
      if (std::isfinite(candidate_energy) && candidate_energy <= energy + 1e-4 * length * slope + rounding) {
        accepted = true;
        x_um = candidate;
        energy = candidate_energy;
        gradient = candidate_gradient;
      } else {
        length *= 0.5;
      }
    }
    if (!accepted) {
      report.status = SolveStatus::kNoDescent;
      return report;
    }
  }
}

Eigen::Matrix3Xd EquilibriumSolver::apply_inverse_hessian(const MembraneModel& model, const Eigen::Matrix3Xd& x_um,
                                                          const Eigen::Matrix3Xd& b) {
  Eigen::Matrix3Xd gradient;
  double energy = 0.0;
  if (impl_->factorize(model, x_um, energy, gradient) < 0) return Eigen::Matrix3Xd::Zero(3, x_um.cols());
  const Eigen::VectorXd solution = impl_->apply_inverse(flat(b));
  return Eigen::Map<const Eigen::Matrix3Xd>(solution.data(), 3, x_um.cols());
}

}  // namespace pellucida
