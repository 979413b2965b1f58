#include "pellucida/linear_algebra/BlockLdlt.h"

#include <array>
#include <cmath>

#include "DenseLdlt.h"
#include "FrontTree.h"

namespace pellucida {
namespace {

NodeGraph graph_of(const BlockMatrix& pattern) {
  NodeGraph graph(static_cast<std::size_t>(pattern.node_count()));
  for (int column = 0; column < pattern.node_count(); ++column) {
    const auto c = static_cast<std::size_t>(column);
    for (int k = pattern.column_starts()[c] + 1; k < pattern.column_starts()[c + 1]; ++k) {
      const int row = pattern.block_rows()[static_cast<std::size_t>(k)];
      graph[c].push_back(row);
      graph[static_cast<std::size_t>(row)].push_back(column);
    }
  }
  return graph;
}

FrontTree best_tree(const NodeGraph& graph) {
  FrontTree dissection = make_front_tree(graph, dissection_order(graph));
  FrontTree minimum_degree = make_front_tree(graph, minimum_degree_order(graph));
  return dissection.operation_count < minimum_degree.operation_count ? std::move(dissection)
                                                                     : std::move(minimum_degree);
}

}  // namespace

class BlockLdlt::Impl {
 public:
  explicit Impl(const BlockMatrix& pattern) : tree_(best_tree(graph_of(pattern))) {
    // Panels one after the other; Schur complements on two stacks by depth, since a front's own is made while its
    // children's are still needed, and theirs go as it is done.
    std::array<std::size_t, 2> used{}, most{};
    std::size_t entries = 0;
    for (const Front& front : tree_.fronts) {
      panel_starts_.push_back(entries);
      entries +=
          9 * static_cast<std::size_t>(front.count) * (static_cast<std::size_t>(front.count) + front.rows.size());
      const auto side = static_cast<std::size_t>(front.depth % 2);
      rest_starts_.push_back(used[side]);
      used[side] += 9 * front.rows.size() * front.rows.size();
      most[side] = std::max(most[side], used[side]);
      for (const int child : front.children) {
        used[1 - side] -= 9 * tree_.fronts[static_cast<std::size_t>(child)].rows.size() *
                          tree_.fronts[static_cast<std::size_t>(child)].rows.size();
      }
    }
    panels_.resize(entries);
    for (std::size_t side = 0; side < 2; ++side) rests_[side].resize(most[side]);
    place_blocks(pattern);
  }

  bool factorize(const BlockMatrix& matrix, double shift) {
    std::fill(panels_.begin(), panels_.end(), 0.0);
    std::size_t block = 0;
    negative_count_ = 0;
    for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
      const Front& front = tree_.fronts[f];
      const int rows = front_rows(front), pivots = 3 * front.count;
      double* panel = panels_.data() + panel_starts_[f];
      double* rest = rest_of(f);
      std::fill(rest, rest + static_cast<std::ptrdiff_t>(rows - pivots) * (rows - pivots), 0.0);

      // The matrix' own blocks, then what the children's eliminations left.
      for (; block < blocks_.size() && blocks_[block].front == static_cast<int>(f); ++block) {
        const Eigen::Map<const Eigen::Matrix3d> value(matrix.values() + blocks_[block].source);
        Eigen::Map<Eigen::Matrix3d, 0, Eigen::OuterStride<>> target(panel + blocks_[block].target,
                                                                    Eigen::OuterStride<>(rows));
        if (blocks_[block].transposed) {
          target = value.transpose();
        } else {
          target = value;
        }
      }
      for (int k = 0; k < pivots; ++k) panel[static_cast<std::ptrdiff_t>(k) * (rows + 1)] += shift;
      for (const int child : front.children) add_child(static_cast<std::size_t>(child), panel, rest, rows, front.count);

      eliminate_columns(panel, rest, rows, pivots, workspace_);
      for (int k = 0; k < pivots; ++k) {
        const double pivot = panel[static_cast<std::ptrdiff_t>(k) * (rows + 1)];
        if (!std::isfinite(pivot) || pivot == 0.0) return false;
        negative_count_ += pivot < 0.0 ? 1 : 0;
      }
    }
    return true;
  }

  int negative_count() const noexcept { return negative_count_; }
  long long entry_count() const noexcept { return static_cast<long long>(panels_.size()); }
  double operation_count() const noexcept { return tree_.operation_count; }

  void solve(Eigen::Ref<Eigen::MatrixXd> right) {
    // Into the order of elimination.
    const Eigen::Index n = right.rows() / 3, width = right.cols();
    ordered_.resize(right.rows(), width);
    for (Eigen::Index k = 0; k < n; ++k) {
      ordered_.middleRows<3>(3 * k) = right.middleRows<3>(3 * tree_.order[static_cast<std::size_t>(k)]);
    }

    // Down with L, each front's rows gathered and scattered together; then D; then up with L^T.
    for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
      const Front& front = tree_.fronts[f];
      const auto panel = panel_of(f);
      const Eigen::Index pivots = panel.cols(), below = panel.rows() - pivots;
      auto top = ordered_.middleRows(3 * front.first, pivots);
      panel.topRows(pivots).triangularView<Eigen::UnitLower>().solveInPlace(top);
      if (below > 0) {
        gathered_.resize(below, width);
        gathered_.noalias() = panel.bottomRows(below) * top;
        for (std::size_t r = 0; r < front.rows.size(); ++r) {
          ordered_.middleRows<3>(3 * front.rows[r]) -= gathered_.middleRows<3>(3 * static_cast<Eigen::Index>(r));
        }
      }
      top.array().colwise() /= panel.diagonal().array();
    }
    for (std::size_t f = tree_.fronts.size(); f-- > 0;) {
      const Front& front = tree_.fronts[f];
      const auto panel = panel_of(f);
      const Eigen::Index pivots = panel.cols(), below = panel.rows() - pivots;
      auto top = ordered_.middleRows(3 * front.first, pivots);
      if (below > 0) {
        gathered_.resize(below, width);
        for (std::size_t r = 0; r < front.rows.size(); ++r) {
          gathered_.middleRows<3>(3 * static_cast<Eigen::Index>(r)) = ordered_.middleRows<3>(3 * front.rows[r]);
        }
        top.noalias() -= panel.bottomRows(below).transpose() * gathered_;
      }
      panel.topRows(pivots).triangularView<Eigen::UnitLower>().transpose().solveInPlace(top);
    }

    for (Eigen::Index k = 0; k < n; ++k) {
      right.middleRows<3>(3 * tree_.order[static_cast<std::size_t>(k)]) = ordered_.middleRows<3>(3 * k);
    }
  }

 private:
  struct PlacedBlock {
    int front = 0;
    int source = 0;             // first value in the matrix
    std::ptrdiff_t target = 0;  // first value in the front's panel
    bool transposed = false;
  };

  static int front_rows(const Front& front) noexcept { return 3 * (front.count + static_cast<int>(front.rows.size())); }
  Eigen::Map<const Eigen::MatrixXd> panel_of(std::size_t f) const {
    return {panels_.data() + panel_starts_[f], front_rows(tree_.fronts[f]), 3 * tree_.fronts[f].count};
  }
  double* rest_of(std::size_t f) {
    return rests_[static_cast<std::size_t>(tree_.fronts[f].depth % 2)].data() + rest_starts_[f];
  }

  void place_blocks(const BlockMatrix& pattern) {
    std::vector<int> front_at(tree_.order.size());
    for (std::size_t f = 0; f < tree_.fronts.size(); ++f) {
      for (int k = 0; k < tree_.fronts[f].count; ++k) {
        front_at[static_cast<std::size_t>(tree_.fronts[f].first + k)] = static_cast<int>(f);
      }
    }
    for (int column = 0; column < pattern.node_count(); ++column) {
      const auto c = static_cast<std::size_t>(column);
      for (int k = pattern.column_starts()[c]; k < pattern.column_starts()[c + 1]; ++k) {
        const int node = pattern.block_rows()[static_cast<std::size_t>(k)];
        int row = tree_.place[static_cast<std::size_t>(node)], col = tree_.place[c];
        const bool transposed = row < col;
        if (transposed) std::swap(row, col);
        const int f = front_at[static_cast<std::size_t>(col)];
        const Front& front = tree_.fronts[static_cast<std::size_t>(f)];
        int local = row - front.first;
        if (local >= front.count) {
          local = front.count +
                  static_cast<int>(std::lower_bound(front.rows.begin(), front.rows.end(), row) - front.rows.begin());
        }
        blocks_.push_back(
            {f, 9 * k, 3 * static_cast<std::ptrdiff_t>(col - front.first) * front_rows(front) + 3 * local, transposed});
      }
    }
    std::sort(blocks_.begin(), blocks_.end(), [](const PlacedBlock& a, const PlacedBlock& b) {
      return a.front != b.front ? a.front < b.front : a.target < b.target;
    });
  }

  /// Adds a child's Schur complement to its parent's front, 3 x 3 blocks of the lower half.
  void add_child(std::size_t child, double* panel, double* rest, int rows, int count) {
    const std::vector<int>& places = tree_.fronts[child].parent_rows;
    const auto size = static_cast<std::ptrdiff_t>(3 * places.size());
    const std::ptrdiff_t rest_rows = rows - 3 * count;
    const double* from = rest_of(child);
    for (std::size_t c = 0; c < places.size(); ++c) {
      const int column = places[c];
      const bool in_panel = column < count;
      const std::ptrdiff_t stride = in_panel ? rows : rest_rows;
      double* target = in_panel ? panel + 3 * column * stride : rest + 3 * (column - count) * (stride)-3 * count;
      for (int k = 0; k < 3; ++k, from += size, target += stride) {
        for (std::size_t r = c; r < places.size(); ++r) {
          const double* value = from + 3 * r;
          double* place = target + 3 * places[r];
          place[0] += value[0];
          place[1] += value[1];
          place[2] += value[2];
        }
      }
    }
  }

  FrontTree tree_;
  std::vector<std::size_t> panel_starts_;
  std::vector<std::size_t> rest_starts_;
  std::vector<double> panels_;
  std::array<std::vector<double>, 2> rests_;
  std::vector<PlacedBlock> blocks_;
  DenseWorkspace workspace_;
  Eigen::MatrixXd ordered_;
  Eigen::MatrixXd gathered_;
  int negative_count_ = 0;
};

BlockLdlt::BlockLdlt(const BlockMatrix& pattern) : impl_(std::make_unique<Impl>(pattern)) {}
BlockLdlt::~BlockLdlt() = default;
bool BlockLdlt::factorize(const BlockMatrix& matrix, double shift) {
  return impl_->factorize(matrix, shift);
}
int BlockLdlt::negative_count() const noexcept {
  return impl_->negative_count();
}
void BlockLdlt::solve(Eigen::Ref<Eigen::MatrixXd> right) const {
  impl_->solve(right);
}
long long BlockLdlt::entry_count() const noexcept {
  return impl_->entry_count();
}
double BlockLdlt::operation_count() const noexcept {
  return impl_->operation_count();
}

}  // namespace pellucida
