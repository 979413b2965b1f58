#include "RigidMotion.h"

#include <Eigen/Dense>

namespace pellucida {

bool RigidMotion::learn(const FrameSampler& image, const std::vector<Eigen::Vector2d>& points, double noise) {
  reset();
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  double sum = 0.0, squares = 0.0;
  for (const Eigen::Vector2d& p : points) {
    if (!image.inside(p, 4.0)) continue;
    const Eigen::Vector2d g(0.5 * (image.sample(p.x() + 1, p.y()) - image.sample(p.x() - 1, p.y())),
                            0.5 * (image.sample(p.x(), p.y() + 1) - image.sample(p.x(), p.y() - 1)));
    information += g * g.transpose();
    const double value = image.sample(p);
    points_.push_back(p);
    values_.push_back(value);
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(points_.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(information);
  // Both directions need structure: one edge alone slides along itself.
  const double weakest = eigen.eigenvalues()[0];
  if (n < 60 || !(weakest > 0.0) || noise / std::sqrt(weakest) > 0.1 || weakest < 1e-4 * eigen.eigenvalues()[1]) {
    reset();
    return false;
  }
  noise_ = noise;
  spread_ = std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
  return spread_ > 0.0;
}

bool RigidMotion::refine(const FrameSampler& image, Eigen::Vector2d& motion, double& residual) const {
  double gain = 0.0, offset = 0.0;
  for (int round = 0; round < 14; ++round) {
    // Pixels that something else covers now (a membrane that bulges beside the rim) must not pull: tolerant at first,
    // then strict.
    const double scale = std::max(3.0 * noise_, (round < 4 ? 0.5 : 0.12) * spread_);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double weight = 0.0, rest = 0.0;
    int seen = 0;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      const Eigen::Vector2d p = points_[k] + motion;
      if (!image.inside(p, 2.0)) continue;
      const double gx = 0.5 * (image.sample(p.x() + 1, p.y()) - image.sample(p.x() - 1, p.y()));
      const double gy = 0.5 * (image.sample(p.x(), p.y() + 1) - image.sample(p.x(), p.y() - 1));
      const double off = image.sample(p) - values_[k];
      const double r = (off + gain * values_[k] + offset) / scale;
      const double w = 1.0 / ((1.0 + r * r) * (1.0 + r * r));
      const Eigen::Vector4d row(gx, gy, values_[k], 1.0);
      normal += w * row * row.transpose();
      right -= w * off * row;
      weight += w;
      rest += std::min(std::abs(off + gain * values_[k] + offset), spread_);
      ++seen;
    }
    if (weight < 40.0) return false;
    residual = rest / seen;
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    if (!step.allFinite()) return false;
    const Eigen::Vector2d move = step.head<2>().cwiseMin(2.0).cwiseMax(-2.0);
    motion += move;
    gain = step[2];
    offset = step[3];
    if (move.norm() < 0.003 && round > 5) break;
  }
  return residual < 0.6 * spread_;
}

bool RigidMotion::track(const FrameSampler& image, double reach_px, const Eigen::Vector2d& hint) {
  if (!valid()) return false;
  Eigen::Vector2d best = motion_;
  double least = 0.35 * spread_;
  bool found = false;
  const auto attempt = [&](const Eigen::Vector2d& start) {
    Eigen::Vector2d trial = start;
    double residual = 1e9;
    if (!refine(image, trial, residual) || (trial - motion_).norm() > reach_px || residual >= least) return;
    best = trial;
    least = residual;
    found = true;
  };
  attempt(motion_);
  // The long walls fit anywhere along themselves: a jump shows at the rim only, so the better of the two starts is
  // taken.
  if (hint.norm() > 4.0) attempt(motion_ + hint);
  // Nothing near: starts round about.
  for (double radius = 6.0; radius <= reach_px && !found; radius += 6.0) {
    for (int k = 0; k < 12; ++k)
      attempt(motion_ + radius * Eigen::Vector2d(std::cos(k * M_PI / 6), std::sin(k * M_PI / 6)));
  }
  if (found) motion_ = best;
  return found;
}

}  // namespace pellucida
