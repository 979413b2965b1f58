#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "pellucida/linear_algebra/BlockMatrix.h"

namespace pellucida {

/// One part of the energy that the nodes' positions x (3 x n, um) minimise: U(x) in uN um, its gradient in uN, its
/// Hessian in uN/um. A solver binds a term to a matrix once and evaluates it many times.
class EnergyTerm {
 public:
  virtual ~EnergyTerm() = default;

  /// Appends the pairs of different nodes that the sparse part of the Hessian couples. None for a term that acts on
  /// each node by itself.
  virtual void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const { (void)pairs; }

  /// Finds this term's blocks in `matrix`, which must hold them. Needed before a Hessian is asked for.
  virtual void bind(const BlockMatrix& matrix) = 0;

  /// Returns the energy at `x_um`; adds the gradient, and the sparse part of the Hessian, where they are not null.
  virtual double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const = 0;

  /// Whether the Hessian has besides a full part of rank one, c g g^T.
  virtual bool has_rank_one() const noexcept { return false; }

  /// That part: writes g (3 x n) and returns c > 0. Only asked for where `has_rank_one`.
  virtual double rank_one(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd& direction) const {
    (void)x_um, (void)direction;
    return 0.0;
  }
};

/// The energy a solver minimises: a sum of terms, which it doesn't own and which must stay where they are. Terms may
/// change their constants between two solutions.
class EnergySum {
 public:
  /// `force_scale_uN_per_um` > 0 (E h, say): the scale of a node's residual force.
  EnergySum(int node_count, double force_scale_uN_per_um);

  /// Adds a term. Once a solver is made for the sum, the term may couple only nodes that are coupled already.
  void add_term(EnergyTerm& term);
  /// Removes a term.
  void remove_term(const EnergyTerm& term);
  /// Binds `term`, one of this sum, again, after it has started to act on other nodes.
  void rebind(EnergyTerm& term);

  int node_count() const noexcept { return node_count_; }
  double force_scale_uN_per_um() const noexcept { return force_scale_uN_per_um_; }
  const std::vector<EnergyTerm*>& terms() const noexcept { return terms_; }
  /// Every pair of nodes that some term couples.
  std::vector<std::pair<int, int>> coupled_nodes() const;

  /// Binds all terms, also those added later, to `matrix`, which must outlive the sum's use; null releases it.
  void bind(const BlockMatrix* matrix);

  /// Energy, uN um; adds gradient and the sparse part of the Hessian where asked for.
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const;

 private:
  int node_count_ = 0;
  double force_scale_uN_per_um_ = 0.0;
  std::vector<EnergyTerm*> terms_;
  const BlockMatrix* bound_ = nullptr;
};

}  // namespace pellucida
