#pragma once
#include <Eigen/Core>
#include <vector>

#include "CyclicBandSolver.h"

namespace pellucida {

/// One relaxation of an active contour. The points x_i = p_i + u_i n_i move along their normals so that
///   E(u) = sum_i w_i (u_i - e_i)^2 + alpha sum_i |lambda_i (p_i+1 - p_i) + u_i+1 n_i+1 - u_i n_i|^2
///        + sum_i beta_i |lambda_i q_i + u_i-1 n_i-1 - 2 u_i n_i + u_i+1 n_i+1|^2,  q_i = p_i-1 - 2 p_i + p_i+1
/// is smallest: e_i where the edge was seen along normal i, w_i = (reference / sigma_i)^2 how surely. lambda_i is the
/// share of the predicted shape's own bending that is penalised: 1 the classic snake, which rounds whatever is curved,
/// 0 one that only keeps its motion smooth. What the smoothing took off the edges is smoothed and given back once
/// ("twicing"), which leaves the square of the relative bias: (1 - h)^2 instead of 1 - h for a mode passed by h.
class Snake {
 public:
  struct Stiffness {
    double elasticity = 0.02;   ///< alpha
    double reference_px = 0.4;  ///< sigma of an edge of weight 1
  };

  /// Displacements (n) along the normals, px. points, normals (2 x n, n >= 5), edges and sigma (n, px), rigidity (n,
  /// beta), shape_share (n, lambda). Edges far off what their neighbours say lose weight once. Cost about 15 us for n =
  /// 192; memory is kept.
  const Eigen::VectorXd& relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                               const Eigen::VectorXd& edges, const Eigen::VectorXd& sigma,
                               const Eigen::VectorXd& rigidity, const Eigen::VectorXd& shape_share,
                               const Stiffness& stiffness);

  /// The classic snake, lambda = 1 and no twicing, with weights (n, 0 where nothing is seen) instead of sigmas: for
  /// edges of which no more than the strength is known.
  const Eigen::VectorXd& relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                               const Eigen::VectorXd& edges, const Eigen::VectorXd& weights,
                               const Eigen::VectorXd& rigidity, double elasticity);

  /// Standard deviation of each displacement (n), px, after relax(): the edges' noise as the smoothing passes it on,
  /// and what the smoothing may have taken away.
  const Eigen::VectorXd& deviation(const Eigen::VectorXd& edges);

 private:
  void bend(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& rigidity,
            const Eigen::VectorXd& shape_share, double elasticity);
  bool solve(const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& edges, const Eigen::VectorXd& rigidity,
             double elasticity);
  void assemble(const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& rigidity, double elasticity);

  CyclicBandSolver solver_;
  Eigen::VectorXd weights_, bend_, ones_, displacement_, correction_, deviation_;
  Eigen::Matrix2Xd second_;
  double reference_px_ = 0.4;
};

}  // namespace pellucida
