#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

namespace pellucida {

/// The active contour's linear part. Each point moves along its own normal by u_i; u minimises
///   sum_i w_i (u_i - e_i)^2 + alpha sum_i |x_{i+1} - x_i|^2 + sum_i beta_i |x_{i-1} - 2 x_i + x_{i+1}|^2,
///   x_i = p_i + u_i n_i,
/// with e_i the edge found on normal i: one symmetric positive definite solve of a cyclic band matrix of width 5.
class Snake {
 public:
  /// The displacements u (n), px. `points`, `normals` (2 x n), n >= 5; `edges`, `weights`, `rigidity` (n), weights >=
  /// 0.
  const Eigen::VectorXd& relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                               const Eigen::VectorXd& edges, const Eigen::VectorXd& weights,
                               const Eigen::VectorXd& rigidity, double elasticity);

 private:
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_, displacement_;
  Eigen::Index analysed_for_ = 0;
};

}  // namespace pellucida
