#include "pellucida/mechanics/BlockMatrix.h"

#include <algorithm>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {

BlockMatrix::BlockMatrix(int node_count, const std::vector<std::pair<int, int>>& node_pairs)
    : node_count_(node_count), rows_(static_cast<std::size_t>(node_count)), values_(3 * node_count, 3 * node_count) {
  // Block rows of each block column, diagonal first.
  for (int node = 0; node < node_count; ++node) rows_[static_cast<std::size_t>(node)].push_back(node);
  for (const auto& [a, b] : node_pairs) rows_[static_cast<std::size_t>(std::min(a, b))].push_back(std::max(a, b));
  for (auto& rows : rows_) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }

  // Explicit zeros hold the places.
  std::vector<Eigen::Triplet<double>> places;
  for (int column = 0; column < node_count; ++column) {
    for (const int row : rows_[static_cast<std::size_t>(column)]) {
      for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) places.emplace_back(3 * row + r, 3 * column + c, 0.0);
      }
    }
  }
  values_.setFromTriplets(places.begin(), places.end());
  values_.makeCompressed();
}

BlockSlot BlockMatrix::slot(int row, int column) const {
  const bool transposed = row < column;
  if (transposed) std::swap(row, column);
  const auto& rows = rows_[static_cast<std::size_t>(column)];
  const auto found = std::lower_bound(rows.begin(), rows.end(), row);
  if (found == rows.end() || *found != row) {
    throw Error(ExitCode::kOurFault, "block matrix: nodes " + std::to_string(row) + " and " + std::to_string(column) +
                                         " aren't coupled in its pattern; name all terms before the solver is made");
  }
  const auto place = found - rows.begin();
  return {values_.outerIndexPtr()[3 * column] + 3 * static_cast<int>(place), 3 * static_cast<int>(rows.size()),
          transposed};
}

void BlockMatrix::add_to_diagonal(double value) noexcept {
  for (int node = 0; node < node_count_; ++node) {
    const BlockSlot place = slot(node, node);
    for (int k = 0; k < 3; ++k) values_.valuePtr()[place.first + k * place.stride + k] += value;
  }
}

}  // namespace pellucida
