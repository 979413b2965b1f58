#include "pellucida/mechanics/EquilibriumSolver.h"

#include <Eigen/Dense>
#include <chrono>
#include <cmath>

#include "pellucida/mechanics/BlockLdlt.h"

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
    case SolveStatus::kTimeBudget:
      return "time budget spent";
    case SolveStatus::kNotPositiveDefinite:
      return "Hessian not positive definite, and no shift helps";
    case SolveStatus::kNoDescent:
      return "no descent";
    case SolveStatus::kNotFinite:
      return "not finite";
  }
  return "unknown";
}

class EquilibriumSolver::Impl {
 public:
  explicit Impl(EnergySum& energy)
      : energy_(energy),
        hessian_(energy.node_count(), energy.coupled_nodes()),
        factor_(hessian_),
        gradient_(3, energy.node_count()) {
    energy_.bind(&hessian_);
  }
  ~Impl() { energy_.bind(nullptr); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  EnergySum& energy() noexcept { return energy_; }
  bool has_factor() const noexcept { return has_factor_; }

  /// The sparse part of the Hessian at `x_um`.
  void assemble(const Eigen::Matrix3Xd& x_um) {
    hessian_.set_zero();
    energy_.add(x_um, nullptr, &hessian_);
  }

  /// A positive definite factorisation of the assembled Hessian, with the rank-one parts of `x_um`. Returns the number
  /// of shifts it took, -1 when none helps.
  int factorize(const Eigen::Matrix3Xd& x_um) {
    has_factor_ = false;
    double shift = 0.0;
    for (int shifts = 0; shifts < 24; ++shifts) {
      const bool factorized = factor_.factorize(hessian_, shift);
      if (factorized && factor_.negative_count() <= rank_one_count() && refresh_rank_ones(x_um)) {
        has_factor_ = true;
        return shifts;
      }
      shift = shift > 0.0 ? 4.0 * shift : 1e-3 * energy_.force_scale_uN_per_um();
    }
    return -1;
  }

  /// Takes the rank-one parts G C G^T at `x_um` into the kept factorisation of S. False when H = S + G C G^T is not
  /// positive definite: S has as many negative eigenvalues as negative pivots, and H has fewer by those that
  /// C^-1 + G^T S^-1 G has (Haynsworth's inertia additivity on the matrix bordered by G).
  bool refresh_rank_ones(const Eigen::Matrix3Xd& x_um) {
    const Eigen::Index count = rank_one_count();
    directions_.resize(x_um.size(), count);
    solved_directions_.resize(x_um.size(), count);
    factors_.resize(count);
    Eigen::Index k = 0;
    for (const EnergyTerm* term : energy_.terms()) {
      if (!term->has_rank_one()) continue;
      factors_[k] = term->rank_one(x_um, gradient_);
      directions_.col(k) = flat(gradient_);
      ++k;
    }
    solved_directions_ = directions_;
    factor_.solve(solved_directions_);
    Eigen::MatrixXd capacitance = directions_.transpose() * solved_directions_;
    capacitance.diagonal() += factors_.cwiseInverse();
    capacitance_inverse_ = capacitance.inverse();
    if (count == 0) return factor_.negative_count() == 0;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(capacitance, Eigen::EigenvaluesOnly);
    return factor_.negative_count() == (spectrum.eigenvalues().array() < 0.0).count();
  }

  /// M^-1 b with M = S + G C G^T, S as last factorised (Sherman, Morrison, Woodbury):
  /// S^-1 b - S^-1 G (C^-1 + G^T S^-1 G)^-1 G^T S^-1 b.
  Eigen::VectorXd apply_inverse(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = b;
    factor_.solve(x);
    if (factors_.size() > 0) x -= solved_directions_ * (capacitance_inverse_ * (directions_.transpose() * x));
    return x;
  }

  /// H v with the assembled Hessian.
  Eigen::VectorXd multiply(const Eigen::VectorXd& v) const {
    Eigen::VectorXd product;
    hessian_.multiply(v, product);
    if (factors_.size() > 0) product += directions_ * factors_.cwiseProduct(directions_.transpose() * v);
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
  int rank_one_count() const {
    int count = 0;
    for (const EnergyTerm* term : energy_.terms()) count += term->has_rank_one() ? 1 : 0;
    return count;
  }

  EnergySum& energy_;
  BlockMatrix hessian_;
  BlockLdlt factor_;
  bool has_factor_ = false;
  Eigen::Matrix3Xd gradient_;
  Eigen::MatrixXd directions_;           // G, (3n x k)
  Eigen::MatrixXd solved_directions_;    // S^-1 G
  Eigen::VectorXd factors_;              // C, (k)
  Eigen::MatrixXd capacitance_inverse_;  // (C^-1 + G^T S^-1 G)^-1
};

EquilibriumSolver::EquilibriumSolver(EnergySum& energy) : impl_(std::make_unique<Impl>(energy)) {}
EquilibriumSolver::~EquilibriumSolver() = default;

SolveReport EquilibriumSolver::solve(Eigen::Matrix3Xd& x_um, const SolveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const EnergySum& model = impl_->energy();
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
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options.time_budget_s) {
      report.status = SolveStatus::kTimeBudget;
      return report;
    }

    // The direction down: by the kept factorisation while that serves alone; by conjugate gradients on the Hessian of
    // this shape, with the kept factorisation as preconditioner, while that is quick; else by a factorisation made
    // here.
    ++report.iterations;
    bool is_exact = false;
    bool has_step = false;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(x_um.size());
    if (impl_->has_factor() && impl_->refresh_rank_ones(x_um)) {
      if (factor_is_good) {
        step = -impl_->apply_inverse(flat(gradient));
        has_step = true;
      } else if (!conjugate_gradients_failed) {
        impl_->assemble(x_um);
        has_step = impl_->conjugate_gradients(-flat(gradient), kStepAccuracy, kMostStepIterations, step);
      }
    }
    if (!has_step) {
      impl_->assemble(x_um);
      const int shifts = impl_->factorize(x_um);
      ++report.factorizations;
      if (shifts < 0) {
        report.status = SolveStatus::kNotPositiveDefinite;
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

Eigen::Matrix3Xd EquilibriumSolver::apply_inverse_hessian(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& b,
                                                          const Eigen::Matrix3Xd& guess) {
  const Eigen::VectorXd right = flat(b);
  Eigen::VectorXd solution = flat(guess);
  impl_->assemble(x_um);
  const bool kept_serves = impl_->has_factor() && impl_->refresh_rank_ones(x_um) &&
                           impl_->conjugate_gradients(right, kTangentAccuracy, kMostTangentIterations, solution);
  if (!kept_serves) {
    if (impl_->factorize(x_um) < 0) return Eigen::Matrix3Xd::Zero(3, x_um.cols());
    solution = impl_->apply_inverse(right);
  }
  return Eigen::Map<const Eigen::Matrix3Xd>(solution.data(), 3, x_um.cols());
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
