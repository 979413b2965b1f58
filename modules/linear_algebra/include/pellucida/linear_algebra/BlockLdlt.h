#pragma once
#include <Eigen/Core>
#include <memory>

#include "pellucida/linear_algebra/BlockMatrix.h"

namespace pellucida {

/// Factorisation S = L D L^T of a symmetric BlockMatrix, D diagonal of either sign. Multifrontal: runs of nodes with
/// the same pattern are eliminated together in dense fronts. The order of elimination (nested dissection or minimum
/// degree, whichever needs fewer operations) and all positions are determined once. About 10 n log n blocks and, on a
/// surface of n nodes, 27 n^1.5 (measured: 60 to 90) thousand operations; nothing is allocated after the first
/// factorisation.
class BlockLdlt {
 public:
  explicit BlockLdlt(const BlockMatrix& pattern);
  ~BlockLdlt();
  BlockLdlt(const BlockLdlt&) = delete;
  BlockLdlt& operator=(const BlockLdlt&) = delete;

  /// Factorises `matrix` + shift I, `matrix` of the pattern given. No pivoting: false when a pivot vanishes or a number
  /// isn't finite; `solve` must not be called then.
  bool factorize(const BlockMatrix& matrix, double shift = 0.0);

  /// Pivots below zero: as many as S has negative eigenvalues (Sylvester).
  int negative_count() const noexcept;

  /// Overwrites each column of `right` (3n x k) with S^-1 times it.
  void solve(Eigen::Ref<Eigen::MatrixXd> right) const;

  /// Numbers in L, and multiplications of one factorisation.
  long long entry_count() const noexcept;
  double operation_count() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
