#include "NewtonSystem.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

/// The first shift, as a share of the force scale, and what each further one is multiplied by.
constexpr double kFirstShift = 1e-3;
constexpr double kShiftGrowth = 4.0;
constexpr int kMostShifts = 24;

}  // namespace

NewtonSystem::NewtonSystem(EnergySum& energy)
    : energy_(energy), sparse_(energy.node_count(), energy.coupled_nodes()), factor_(sparse_) {
  energy_.bind(&sparse_);
}

int NewtonSystem::rank_one_count() const {
  int count = 0;
  for (const EnergyTerm* term : energy_.terms()) count += term->has_rank_one() ? 1 : 0;
  return count;
}

void NewtonSystem::assemble(const Eigen::Matrix3Xd& x_um) {
  sparse_.set_zero();
  energy_.add(x_um, nullptr, &sparse_);
  const int count = rank_one_count();
  directions_.resize(x_um.size(), count);
  factors_.resize(count);
  Eigen::Index k = 0;
  for (const EnergyTerm* term : energy_.terms()) {
    if (!term->has_rank_one()) continue;
    factors_[k] = term->rank_one(x_um, direction_);
    directions_.col(k++) = direction_.reshaped();
  }
}

int NewtonSystem::factorize() {
  has_factor_ = false;
  const double first_shift = std::max(kFirstShift * energy_.force_scale_uN_per_um(), last_shift_ / kShiftGrowth);
  double shift = 0.0;
  for (int shifts = 0; shifts < kMostShifts; ++shifts) {
    // Each rank-one part, being positive, can lift one negative direction at most.
    if (factor_.factorize(sparse_, shift) && factor_.negative_count() <= rank_one_count() && refresh_rank_ones()) {
      last_shift_ = shift;
      return shifts;
    }
    shift = shift > 0.0 ? kShiftGrowth * shift : first_shift;
  }
  last_shift_ = 0.0;
  return -1;
}

bool NewtonSystem::refresh_rank_ones() {
  // M is positive definite when C^-1 + G^T S^-1 G has as many negative eigenvalues as S: Haynsworth's inertia
  // additivity on the matrix bordered by G.
  factored_directions_ = directions_;
  solved_directions_ = directions_;
  if (factors_.size() == 0) {
    has_factor_ = factor_.negative_count() == 0;
    return has_factor_;
  }
  factor_.solve(solved_directions_);
  Eigen::MatrixXd capacitance = factored_directions_.transpose() * solved_directions_;
  capacitance.diagonal() += factors_.cwiseInverse();
  capacitance_inverse_ = capacitance.inverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(capacitance, Eigen::EigenvaluesOnly);
  has_factor_ = factor_.negative_count() == (spectrum.eigenvalues().array() < 0.0).count();
  return has_factor_;
}

void NewtonSystem::apply_factor(const Eigen::VectorXd& b, Eigen::VectorXd& result) {
  // Sherman, Morrison, Woodbury: S^-1 b - S^-1 G (C^-1 + G^T S^-1 G)^-1 G^T S^-1 b.
  result = b;
  factor_.solve(result);
  if (factored_directions_.cols() == 0) return;
  const Eigen::VectorXd along = capacitance_inverse_ * (factored_directions_.transpose() * result);
  result.noalias() -= solved_directions_ * along;
}

void NewtonSystem::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& result) const {
  sparse_.multiply(v, result);
  for (Eigen::Index k = 0; k < factors_.size(); ++k) {
    result += directions_.col(k) * (factors_[k] * directions_.col(k).dot(v));
  }
}

int NewtonSystem::conjugate_gradients(const Eigen::VectorXd& b, double relative, int most_iterations,
                                      Eigen::VectorXd& x) {
  // From zero the first residual is b itself, and gives the goal; else the goal takes a solution of its own.
  double size = 0.0, goal = 0.0;
  const bool from_zero = x.isZero(0.0);
  if (from_zero) {
    residual_ = b;
  } else {
    apply_factor(b, better_);
    goal = relative * relative * b.dot(better_);
    multiply(x, product_);
    residual_ = b - product_;
  }
  apply_factor(residual_, better_);
  size = residual_.dot(better_);
  if (from_zero) goal = relative * relative * size;
  search_ = better_;
  int taken = 0;
  for (; size > goal; ++taken) {
    if (taken == most_iterations) return -1;
    multiply(search_, product_);
    const double curvature = search_.dot(product_);
    if (!(curvature > 0.0)) return -1;
    x += (size / curvature) * search_;
    residual_ -= (size / curvature) * product_;
    apply_factor(residual_, better_);
    const double next = residual_.dot(better_);
    search_ = better_ + (next / size) * search_;
    size = next;
  }
  return taken;
}

}  // namespace pellucida
