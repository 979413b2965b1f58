#include "Dent.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "ContourMath.h"

namespace pellucida {
namespace {

using Harmonics = Eigen::Matrix<double, 5, 1>;  // circle, shift, ellipse

constexpr double kBesideHolder = 0.5;  // cosine of 60 degrees
constexpr double kUsual_ratio = 0.02;  // of the radius: how far a membrane lies off its ellipse without a needle
constexpr int kRounds = 8;             // of weighing what lies off less

Harmonics harmonics_at(const Eigen::Vector2d& direction) {
  const double c = direction.x(), s = direction.y();
  return {1.0, c, s, c * c - s * s, 2.0 * c * s};
}

}  // namespace

double dent_ratio(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center,
                  const std::optional<Eigen::Vector2d>& holder) {
  const Eigen::Index n = outline.cols();
  if (n < 24) return 0.0;
  const double radius = (outline.colwise() - center).colwise().norm().mean();
  if (!(radius > 0.0)) return 0.0;

  // The distance outside of the fitted ellipse, as a share of the radius.
  Harmonics fitted = Harmonics::Zero();
  fitted[0] = 1.0;
  const auto off_at = [&](Eigen::Index i) {
    const Eigen::Vector2d from_center = outline.col(contour::wrap(i, n)) - center;
    return from_center.norm() / radius - fitted.dot(harmonics_at(from_center.normalized()));
  };
  for (int round = 0; round < kRounds; ++round) {
    Eigen::Matrix<double, 5, 5> normal = 1e-9 * Eigen::Matrix<double, 5, 5>::Identity();
    Harmonics right = Harmonics::Zero();
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d from_center = outline.col(i) - center;
      const Harmonics shape = harmonics_at(from_center.normalized());
      const double off = (from_center.norm() / radius - fitted.dot(shape)) / kUsual_ratio;
      const double weight = 1.0 / std::pow(1.0 + off * off, 2);
      normal += weight * shape * shape.transpose();
      right += weight * from_center.norm() / radius * shape;
    }
    fitted = normal.ldlt().solve(right);
  }

  const Eigen::Index half = std::max<Eigen::Index>(1, n / 60);
  double deepest = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (holder && (outline.col(i) - center).normalized().dot(*holder) > kBesideHolder) continue;
    double sum = 0.0;
    for (Eigen::Index k = -half; k <= half; ++k) sum += off_at(i + k);
    deepest = std::max(deepest, -sum / static_cast<double>(2 * half + 1));
  }
  return deepest;
}

}  // namespace pellucida
