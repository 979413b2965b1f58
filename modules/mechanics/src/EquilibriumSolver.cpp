#include "pellucida/mechanics/EquilibriumSolver.h"

#include <Eigen/SparseCholesky>
#include <cmath>

namespace pellucida {
namespace {
// Conjugate gradients take about half a millisecond an iteration, a factorisation some twenty: measured, these limits
// give the lowest mean and 90 % time of a frame on a ramp of 20 um/s.
constexpr int kMostStepIterations = 2;
constexpr int kMostTangentIterations = 8;
constexpr double kStepAccuracy = 0.03;
constexpr double kTangentAccuracy = 1e-4;

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

  bool has_factor() const noexcept { return has_factor_; }

  /// The sparse part of the Hessian at `x_um`.
  void assemble(const MembraneModel& model, const Eigen::Matrix3Xd& x_um) {
    hessian_.set_zero();
    model.add(x_um, nullptr, &hessian_);
  }

  /// A positive definite factorisation of the assembled Hessian, the volume's slope being that of `x_um`. Returns the
  /// number of shifts it took, -1 when none helps.
  int factorize(const MembraneModel& model, const Eigen::Matrix3Xd& x_um) {
    has_factor_ = false;
    double shift = 0.0;
    for (int shifts = 0; shifts < 24; ++shifts) {
      factor_.setShift(shift);
      factor_.factorize(hessian_.sparse());
      if (factor_.info() == Eigen::Success) {
        const auto pivots = factor_.vectorD();
        negative_count_ = static_cast<int>((pivots.array() > 0.0).size() - (pivots.array() > 0.0).count());
        if (negative_count_ <= 1 && refresh_slope(model, x_um)) {
          has_factor_ = true;
          return shifts;
        }
      }
      shift = shift > 0.0 ? 4.0 * shift : 1e-3 * model.force_scale_uN_per_um();
    }
    return -1;
  }

  /// Takes the volume's slope at `x_um` into the kept factorisation. False when the whole is not positive definite: by
  /// the signs of the pivots S has that many negative eigenvalues; H has one fewer when 1 + c g.S^-1 g < 0
  /// (Haynsworth's inertia additivity on the matrix bordered by g).
  bool refresh_slope(const MembraneModel& model, const Eigen::Matrix3Xd& x_um) {
    const Eigen::Matrix3Xd slope = model.volume().gradient_of_volume(x_um);
    rank_one_factor_ = model.volume().rank_one_factor();
    volume_slope_ = flat(slope);
    factor_of_slope_ = factor_.solve(volume_slope_);
    slope_product_ = volume_slope_.dot(factor_of_slope_);
    const double along = 1.0 + rank_one_factor_ * slope_product_;
    return negative_count_ == 0 ? along > 0.0 : along < 0.0;
  }

  /// M^-1 b with M = S + c g g^T, S as last factorised: S^-1 b - c S^-1 g (g.S^-1 b) / (1 + c g.S^-1 g).
  Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const {
    const Eigen::VectorXd direct = factor_.solve(b);
    return direct - factor_of_slope_ *
                        (rank_one_factor_ * volume_slope_.dot(direct) / (1.0 + rank_one_factor_ * slope_product_));
  }

  /// H v with the assembled Hessian.
  Eigen::VectorXd multiply(const Eigen::VectorXd& v) const {
    Eigen::VectorXd product = hessian_.sparse().selfadjointView<Eigen::Lower>() * v;
    product += volume_slope_ * (rank_one_factor_ * volume_slope_.dot(v));
    return product;
  }

  /// Conjugate gradients for H x = b, preconditioned by M, to a residual of `relative` in M's norm. False when H has a
  /// direction that goes down, or when it takes longer than making a factorisation.
  bool conjugate_gradients(const Eigen::VectorXd& b, double relative, int most_iterations, Eigen::VectorXd& x) const {
    Eigen::VectorXd residual = b - multiply(x);
    Eigen::VectorXd better = apply_inverse(residual);
    Eigen::VectorXd direction = better;
    double size = residual.dot(better);
    const double goal = relative * relative * std::abs(b.dot(apply_inverse(b)));
    for (int k = 0; k < most_iterations && size > goal; ++k) {
      const Eigen::VectorXd product = multiply(direction);
      const double curvature = direction.dot(product);
      if (!(curvature > 0.0)) return false;
      x += (size / curvature) * direction;
      residual -= (size / curvature) * product;
      better = apply_inverse(residual);
      const double next = residual.dot(better);
      direction = better + (next / size) * direction;
      size = next;
    }
    return size <= goal;
  }

 private:
  BlockMatrix hessian_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
  bool has_factor_ = false;
  int negative_count_ = 0;           // pivots of the factorisation that aren't positive
  Eigen::VectorXd volume_slope_;     // g = grad V
  Eigen::VectorXd factor_of_slope_;  // S^-1 g
  double slope_product_ = 0.0;       // g . S^-1 g
  double rank_one_factor_ = 0.0;     // c
};

EquilibriumSolver::EquilibriumSolver(MembraneModel& model) : impl_(std::make_unique<Impl>(model)) {}
EquilibriumSolver::~EquilibriumSolver() = default;

SolveReport EquilibriumSolver::solve(const MembraneModel& model, Eigen::Matrix3Xd& x_um, const SolveOptions& options) {
  SolveReport report;
  const double tolerance_uN = options.tolerance_um * model.force_scale_uN_per_um();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  Eigen::Matrix3Xd candidate, candidate_gradient;

  double energy = model.add(x_um, &gradient, nullptr);
  bool factor_is_good = impl_->has_factor();
  bool conjugate_gradients_failed = false;
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

    // The direction down: by the kept factorisation while that serves alone; by conjugate gradients on the Hessian of
    // this shape, with the kept factorisation as preconditioner, while that is quick; else by a factorisation made
    // here.
    ++report.iterations;
    bool is_exact = false;
    bool has_step = false;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(x_um.size());
    if (impl_->has_factor() && impl_->refresh_slope(model, x_um)) {
      if (factor_is_good) {
        step = -impl_->apply_inverse(flat(gradient));
        has_step = true;
      } else if (!conjugate_gradients_failed) {
        impl_->assemble(model, x_um);
        has_step = impl_->conjugate_gradients(-flat(gradient), kStepAccuracy, kMostStepIterations, step);
      }
    }
    if (!has_step) {
      impl_->assemble(model, x_um);
      const int shifts = impl_->factorize(model, x_um);
      ++report.factorizations;
      if (shifts < 0) {
        report.status = SolveStatus::kNoDescent;
        return report;
      }
      report.shifts += shifts;
      step = -impl_->apply_inverse(flat(gradient));
      is_exact = true;
    }
    const double slope = step.dot(flat(gradient));
    const double reach = largest_column_norm(Eigen::Map<const Eigen::Matrix3Xd>(step.data(), 3, x_um.cols()));
    if (!std::isfinite(slope) || !std::isfinite(reach)) {
      report.status = SolveStatus::kNotFinite;
      return report;
    }

    // Armijo, no node moving too far: accept when the energy drops by its share, or when only rounding is left to argue
    // about.
    double length = std::min(1.0, options.max_step_um / std::max(reach, 1e-12));
    const double rounding = 1e-13 * (std::abs(energy) + model.force_scale_uN_per_um());
    bool accepted = false;
    for (int halving = 0; halving < (is_exact ? 30 : 2) && !accepted; ++halving) {
      candidate = x_um + length * Eigen::Map<const Eigen::Matrix3Xd>(step.data(), 3, x_um.cols());
      candidate_gradient.setZero(3, x_um.cols());
      const double candidate_energy = model.add(candidate, &candidate_gradient, nullptr);
      if (std::isfinite(candidate_energy) && candidate_energy <= energy + 1e-4 * length * slope + rounding) {
        accepted = true;
        energy = candidate_energy;
      } else {
        length *= 0.5;
      }
    }
    if (!accepted && is_exact) {
      report.status = SolveStatus::kNoDescent;
      return report;
    }

    // A factorisation that no longer shrinks the residual well doesn't serve alone; a step that wasn't taken is worse.
    if (accepted) {
      factor_is_good = largest_column_norm(candidate_gradient) < 0.25 * report.residual_uN;
      conjugate_gradients_failed = false;
      x_um = candidate;
      gradient = candidate_gradient;
    } else {
      conjugate_gradients_failed = !factor_is_good;
      factor_is_good = false;
    }
  }
}

Eigen::Matrix3Xd EquilibriumSolver::apply_inverse_hessian(const MembraneModel& model, const Eigen::Matrix3Xd& x_um,
                                                          const Eigen::Matrix3Xd& b, const Eigen::Matrix3Xd& guess) {
  const Eigen::VectorXd right = flat(b);
  Eigen::VectorXd solution = flat(guess);
  impl_->assemble(model, x_um);
  const bool kept_serves = impl_->has_factor() && impl_->refresh_slope(model, x_um) &&
                           impl_->conjugate_gradients(right, kTangentAccuracy, kMostTangentIterations, solution);
  if (!kept_serves) {
    if (impl_->factorize(model, x_um) < 0) return Eigen::Matrix3Xd::Zero(3, x_um.cols());
    solution = impl_->apply_inverse(right);
  }
  return Eigen::Map<const Eigen::Matrix3Xd>(solution.data(), 3, x_um.cols());
}

}  // namespace pellucida
