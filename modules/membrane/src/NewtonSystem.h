#pragma once
#include <Eigen/Core>

#include "pellucida/linear_algebra/BlockLdlt.h"
#include "pellucida/membrane/EnergyTerm.h"

namespace pellucida {

/// The linear system of a Newton step, H = S + G C G^T: S sparse, each column of G the rank-one part of a term. Holds
/// H as last assembled and a factorised M, an H of some time before, possibly shifted, that is always positive
/// definite. Allocates nothing after the first use.
class NewtonSystem {
 public:
  explicit NewtonSystem(EnergySum& energy);
  ~NewtonSystem() { energy_.bind(nullptr); }
  NewtonSystem(const NewtonSystem&) = delete;
  NewtonSystem& operator=(const NewtonSystem&) = delete;

  bool has_factor() const noexcept { return has_factor_; }

  /// H at `x_um`.
  void assemble(const Eigen::Matrix3Xd& x_um);

  /// M = H, shifted along the diagonal until positive definite. Returns the number of shifts it took, -1 when none
  /// helps.
  int factorize();

  /// Takes the rank-one parts last assembled into M. False, and M is of no use any more, when that isn't positive
  /// definite.
  bool refresh_rank_ones();

  /// result = M^-1 b. Needs a factor.
  void apply_factor(const Eigen::VectorXd& b, Eigen::VectorXd& result);

  /// result = H v.
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& result) const;

  /// Conjugate gradients for H x = b from `x`, preconditioned by M, until the residual in the norm of M^-1 is
  /// `relative` times b's. Returns the iterations taken; -1 when H has a direction that goes down, or `most_iterations`
  /// don't do.
  int conjugate_gradients(const Eigen::VectorXd& b, double relative, int most_iterations, Eigen::VectorXd& x);

 private:
  int rank_one_count() const;

  EnergySum& energy_;
  BlockMatrix sparse_;
  BlockLdlt factor_;
  bool has_factor_ = false;
  double last_shift_ = 0.0;  // that made M positive definite; the next search for one begins near it
  Eigen::Matrix3Xd direction_;
  Eigen::MatrixXd directions_;  // G as assembled, (3n x k)
  Eigen::VectorXd factors_;     // C as assembled, (k)
  // M's parts: G, S^-1 G, (C^-1 + G^T S^-1 G)^-1.
  Eigen::MatrixXd factored_directions_;
  Eigen::MatrixXd solved_directions_;
  Eigen::MatrixXd capacitance_inverse_;
  Eigen::VectorXd product_, residual_, better_, search_;
};

}  // namespace pellucida
