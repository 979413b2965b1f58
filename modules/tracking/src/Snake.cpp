#include "Snake.h"

#include <cmath>

namespace pellucida {
namespace {

constexpr double kFarOff = 4.0;  // sigmas at which an edge loses half its weight

}  // namespace

void Snake::assemble(const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& rigidity, double elasticity) {
  const Eigen::Index n = normals.cols();
  solver_.reset(static_cast<int>(n));
  double *diagonal = solver_.diagonal(), *next = solver_.next(), *second_next = solver_.second_next();
  Eigen::Index before = n - 1, after = 1, second = 2;
  for (Eigen::Index i = 0; i < n; ++i) {
    diagonal[i] = weights_[i] + 1e-4 + 2.0 * elasticity + rigidity[before] + 4.0 * rigidity[i] + rigidity[after];
    next[i] = -(elasticity + 2.0 * rigidity[i] + 2.0 * rigidity[after]) * normals.col(i).dot(normals.col(after));
    second_next[i] = rigidity[after] * normals.col(i).dot(normals.col(second));
    before = i;
    after = after + 1 == n ? 0 : after + 1;
    second = second + 1 == n ? 0 : second + 1;
  }
}

// The predicted shape's own bending, along the normals.
void Snake::bend(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& rigidity,
                 const Eigen::VectorXd& shape_share, double elasticity) {
  const Eigen::Index n = points.cols();
  second_.resize(2, n);
  bend_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = i == 0 ? n - 1 : i - 1, after = i + 1 == n ? 0 : i + 1;
    second_.col(i) = shape_share[i] * (points.col(before) - 2.0 * points.col(i) + points.col(after));
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index before = i == 0 ? n - 1 : i - 1, after = i + 1 == n ? 0 : i + 1;
    const Eigen::Vector2d force = rigidity[before] * second_.col(before) - 2.0 * rigidity[i] * second_.col(i) +
                                  rigidity[after] * second_.col(after) - elasticity * second_.col(i);
    bend_[i] = normals.col(i).dot(force);
  }
}

bool Snake::solve(const Eigen::Matrix2Xd& normals, const Eigen::VectorXd& edges, const Eigen::VectorXd& rigidity,
                  double elasticity) {
  assemble(normals, rigidity, elasticity);
  displacement_ = weights_.cwiseProduct(edges) - bend_;
  correction_.setZero(edges.size());
  if (!solver_.factorize()) {
    displacement_.setZero();
    return false;
  }
  solver_.solve(displacement_.data());
  return true;
}

const Eigen::VectorXd& Snake::relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                                    const Eigen::VectorXd& edges, const Eigen::VectorXd& sigma,
                                    const Eigen::VectorXd& rigidity, const Eigen::VectorXd& shape_share,
                                    const Stiffness& stiffness) {
  const Eigen::Index n = points.cols();
  reference_px_ = stiffness.reference_px;
  weights_ = (stiffness.reference_px / sigma.array()).square();
  bend(points, normals, rigidity, shape_share, stiffness.elasticity);
  if (!solve(normals, edges, rigidity, stiffness.elasticity)) return displacement_;

  // Edges far from what their neighbours say lose weight.
  for (Eigen::Index i = 0; i < n; ++i) {
    const double off = (edges[i] - displacement_[i]) / (kFarOff * sigma[i]);
    weights_[i] /= 1.0 + off * off;
  }
  if (!solve(normals, edges, rigidity, stiffness.elasticity)) return displacement_;

  correction_ = weights_.cwiseProduct(edges - displacement_);
  solver_.solve(correction_.data());
  displacement_ += correction_;
  return displacement_;
}

const Eigen::VectorXd& Snake::relax(const Eigen::Matrix2Xd& points, const Eigen::Matrix2Xd& normals,
                                    const Eigen::VectorXd& edges, const Eigen::VectorXd& weights,
                                    const Eigen::VectorXd& rigidity, double elasticity) {
  reference_px_ = 0.4;
  weights_ = weights;
  ones_.setOnes(points.cols());
  bend(points, normals, rigidity, ones_, elasticity);
  solve(normals, edges, rigidity, elasticity);
  return displacement_;
}

const Eigen::VectorXd& Snake::deviation(const Eigen::VectorXd& edges) {
  const Eigen::Index n = edges.size();
  deviation_.resize(n);
  solver_.inverse_diagonal(deviation_.data());
  for (Eigen::Index i = 0; i < n; ++i) {
    const double noise = reference_px_ * reference_px_ * deviation_[i];
    deviation_[i] = std::sqrt(noise + correction_[i] * correction_[i]);
  }
  return deviation_;
}

}  // namespace pellucida
