#include "pellucida/linear_algebra/BlockMatrix.h"

#include <algorithm>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {

BlockMatrix::BlockMatrix(int node_count, const std::vector<std::pair<int, int>>& node_pairs) {
  // Block rows of each block column, diagonal first.
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(node_count));
  for (int node = 0; node < node_count; ++node) rows[static_cast<std::size_t>(node)].push_back(node);
  for (const auto& [a, b] : node_pairs) rows[static_cast<std::size_t>(std::min(a, b))].push_back(std::max(a, b));

  column_starts_.push_back(0);
  for (auto& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    block_rows_.insert(block_rows_.end(), column.begin(), column.end());
    column_starts_.push_back(static_cast<int>(block_rows_.size()));
  }
  values_ = Eigen::VectorXd::Zero(9 * static_cast<Eigen::Index>(block_rows_.size()));
}

BlockSlot BlockMatrix::slot(int row, int column) const {
  const bool transposed = row < column;
  if (transposed) std::swap(row, column);
  const auto begin = block_rows_.begin() + column_starts_[static_cast<std::size_t>(column)];
  const auto end = block_rows_.begin() + column_starts_[static_cast<std::size_t>(column) + 1];
  const auto found = std::lower_bound(begin, end, row);
  if (found == end || *found != row) {
    throw Error(ExitCode::kOurFault, "block matrix: nodes " + std::to_string(row) + " and " + std::to_string(column) +
                                         " aren't coupled in its pattern; name all terms before the solver is made");
  }
  return {9 * static_cast<int>(found - block_rows_.begin()), transposed};
}

void BlockMatrix::multiply(const Eigen::VectorXd& v, Eigen::VectorXd& product) const {
  product.setZero(v.size());
  const double* value = values_.data();
  for (int column = 0; column < node_count(); ++column) {
    const Eigen::Vector3d here = v.segment<3>(3 * column);
    Eigen::Vector3d sum = Eigen::Map<const Eigen::Matrix3d>(value) * here;
    value += 9;
    for (int k = column_starts_[static_cast<std::size_t>(column)] + 1;
         k < column_starts_[static_cast<std::size_t>(column) + 1]; ++k, value += 9) {
      const Eigen::Map<const Eigen::Matrix3d> block(value);
      const int row = block_rows_[static_cast<std::size_t>(k)];
      product.segment<3>(3 * row) += block * here;
      sum += block.transpose() * v.segment<3>(3 * row);
    }
    product.segment<3>(3 * column) += sum;
  }
}

Eigen::SparseMatrix<double> BlockMatrix::sparse() const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * block_rows_.size());
  const double* value = values_.data();
  for (int column = 0; column < node_count(); ++column) {
    for (int k = column_starts_[static_cast<std::size_t>(column)];
         k < column_starts_[static_cast<std::size_t>(column) + 1]; ++k) {
      const int row = block_rows_[static_cast<std::size_t>(k)];
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) entries.emplace_back(3 * row + r, 3 * column + c, *value++);
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(3 * node_count(), 3 * node_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace pellucida
