#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace pellucida {

/// Where one 3 x 3 block sits in a BlockMatrix.
struct BlockSlot {
  int first = 0;            ///< index of the block's first value
  int stride = 0;           ///< distance from one column of the block to the next
  bool transposed = false;  ///< the block asked for lies in the upper half: its transpose is stored
};

/// Symmetric sparse matrix of 3 x 3 blocks, one block row a node; only the lower half is stored (with full diagonal
/// blocks). The pattern is laid down once, so that a factorisation's symbolic part can be kept; adding a block is nine
/// additions.
class BlockMatrix {
 public:
  /// Lays down the pattern: every diagonal block and the block of each pair of different nodes named.
  BlockMatrix(int node_count, const std::vector<std::pair<int, int>>& node_pairs);

  int node_count() const noexcept { return node_count_; }

  /// The slot of block (row, column). Throws Error (our fault) unless the pair was named at construction, or
  /// row == column.
  BlockSlot slot(int row, int column) const;

  void set_zero() { values_.coeffs().setZero(); }

  void add(const BlockSlot& slot, const Eigen::Matrix3d& block) noexcept {
    double* value = values_.valuePtr() + slot.first;
    for (int column = 0; column < 3; ++column, value += slot.stride) {
      for (int row = 0; row < 3; ++row) value[row] += slot.transposed ? block(column, row) : block(row, column);
    }
  }

  void add_to_diagonal(double value) noexcept;

  /// (3n x 3n), lower half valid.
  const Eigen::SparseMatrix<double>& sparse() const noexcept { return values_; }

 private:
  int node_count_ = 0;
  std::vector<std::vector<int>> rows_;  // of each block column: its block rows, sorted
  Eigen::SparseMatrix<double> values_;
};

}  // namespace pellucida
