#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <utility>
#include <vector>

namespace pellucida {

/// Where one 3 x 3 block sits in a BlockMatrix.
struct BlockSlot {
  int first = 0;            ///< index of the block's first value
  bool transposed = false;  ///< the block asked for lies in the upper half: its transpose is stored
};

/// Symmetric sparse matrix of 3 x 3 blocks, one block row a node; only the lower half is stored (with full diagonal
/// blocks), block column by block column, each block's nine values together and column by column. The pattern is laid
/// down once, so that a factorisation's symbolic part can be kept; adding a block is nine additions.
class BlockMatrix {
 public:
  /// Lays down the pattern: every diagonal block and the block of each pair of different nodes named.
  BlockMatrix(int node_count, const std::vector<std::pair<int, int>>& node_pairs);

  int node_count() const noexcept { return static_cast<int>(column_starts_.size()) - 1; }
  int block_count() const noexcept { return static_cast<int>(block_rows_.size()); }

  /// The slot of block (row, column). Throws Error (internal error) unless the pair was named at construction, or row
  /// == column.
  BlockSlot slot(int row, int column) const;

  void set_zero() { values_.setZero(); }

  void add(const BlockSlot& slot, const Eigen::Matrix3d& block) noexcept {
    Eigen::Map<Eigen::Matrix3d> stored(values_.data() + slot.first);
    if (slot.transposed) {
      stored += block.transpose();
    } else {
      stored += block;
    }
  }

  /// product = matrix * v, both of 3 n numbers, node by node.
  void multiply(const Eigen::VectorXd& v, Eigen::VectorXd& product) const;

  /// Block column c holds the blocks column_starts()[c] .. column_starts()[c + 1] - 1, rows ascending, the diagonal's
  /// first; block k has the values values()[9 k] .. values()[9 k + 8].
  const std::vector<int>& column_starts() const noexcept { return column_starts_; }
  const std::vector<int>& block_rows() const noexcept { return block_rows_; }
  const double* values() const noexcept { return values_.data(); }

  /// A copy as a scalar sparse matrix (3n x 3n), lower half valid.
  Eigen::SparseMatrix<double> sparse() const;

 private:
  std::vector<int> column_starts_;
  std::vector<int> block_rows_;
  Eigen::VectorXd values_;
};

}  // namespace pellucida
