#include "Snake.h"

namespace pellucida {

const Eigen::VectorXd& Snake::relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                                    const Eigen::VectorXd& edges, const Eigen::VectorXd& weights,
                                    const Eigen::VectorXd& rigidity, double elasticity) {
  const Eigen::Index n = points.cols();
  right_ = weights.cwiseProduct(edges);
  entries_.clear();
  // Image term; the tiny constant keeps the matrix definite where no edge is seen.
  for (Eigen::Index i = 0; i < n; ++i) entries_.emplace_back(i, i, weights[i] + 1e-4);

  // Adds stiffness * |sum_k c_k (p_k + u_k n_k)|^2 over the points of one difference stencil.
  const auto add_difference = [&](const Eigen::Index* index, const double* c, int count, double stiffness) {
    Eigen::Vector2d rest = Eigen::Vector2d::Zero();
    for (int a = 0; a < count; ++a) rest += c[a] * points.col(index[a]);
    for (int a = 0; a < count; ++a) {
      right_[index[a]] -= stiffness * c[a] * normals.col(index[a]).dot(rest);
      for (int b = 0; b < count; ++b) {
        entries_.emplace_back(index[a], index[b],
                              stiffness * c[a] * c[b] * normals.col(index[a]).dot(normals.col(index[b])));
      }
    }
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = i == 0 ? n - 1 : i - 1, after = i + 1 == n ? 0 : i + 1;
    const Eigen::Index pair[] = {i, after};
    const double first[] = {-1.0, 1.0};
    add_difference(pair, first, 2, elasticity);
    const Eigen::Index triple[] = {before, i, after};
    const double second[] = {1.0, -2.0, 1.0};
    add_difference(triple, second, 3, rigidity[i]);
  }
  matrix_.resize(n, n);
  matrix_.setFromTriplets(entries_.begin(), entries_.end());
  if (analysed_for_ != n) {
    solver_.analyzePattern(matrix_);
    analysed_for_ = n;
  }
  solver_.factorize(matrix_);
  displacement_ = solver_.solve(right_);
  return displacement_;
}

}  // namespace pellucida
