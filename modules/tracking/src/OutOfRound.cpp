#include "OutOfRound.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>

namespace pellucida {
namespace {

constexpr Eigen::Index kFewest = 24;
// Rounds of the fit, from where on distant points count less, and from which distance on, px.
constexpr int kRounds = 6, kPlainRounds = 2;
constexpr double kScale_px = 2.0;
constexpr double kMostOfOutline = 0.4;  // that bumps take; an outline with more of them is not that of an oval

}  // namespace

OutOfRound OutOfRound::of(const Eigen::Matrix2Xd& outline, const contour::Circle& circle) {
  const Eigen::Index n = outline.cols();
  constexpr Eigen::Index kTerms = 2 * kHighest + 1;  // mean, cosine and sine of the first to the highest
  OutOfRound shape;
  if (n < kFewest || circle.radius <= 0.0) return shape;
  Eigen::Matrix<double, Eigen::Dynamic, kTerms> rows(n, kTerms);
  Eigen::VectorXd beyond(n), weight = Eigen::VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d d = outline.col(i) - circle.center;
    const double angle = std::atan2(d.y(), d.x());
    beyond[i] = d.norm() - circle.radius;
    rows(i, 0) = 1.0;
    for (int m = 1; m <= kHighest; ++m) {
      rows(i, 2 * m - 1) = std::cos(m * angle);
      rows(i, 2 * m) = std::sin(m * angle);
    }
  }
  Eigen::Matrix<double, kTerms, 1> fitted;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix<double, kTerms, kTerms> normal = rows.transpose() * weight.asDiagonal() * rows;
    fitted = normal.ldlt().solve(rows.transpose() * weight.asDiagonal() * beyond);
    if (!fitted.allFinite()) return shape;
    if (round + 1 < kPlainRounds) continue;
    const Eigen::VectorXd off = beyond - rows * fitted;
    weight = (1.0 + (off / kScale_px).array().square()).inverse();
  }
  for (int m = kLowest; m <= kHighest; ++m) shape.terms_.col(m - kLowest) << fitted[2 * m - 1], fitted[2 * m];
  const double largest = shape.terms_.colwise().norm().sum();
  return largest > kMost_ratio * circle.radius ? OutOfRound{} : shape;
}

Eigen::VectorXd OutOfRound::bumps(const Eigen::Matrix2Xd& outline, const contour::Circle& circle) {
  const OutOfRound shape = of(outline, circle);
  Eigen::VectorXd beyond_px(outline.cols());
  for (Eigen::Index i = 0; i < outline.cols(); ++i) {
    const Eigen::Vector2d d = outline.col(i) - circle.center;
    beyond_px[i] = std::max(0.0, d.norm() - circle.radius - shape.at(d.normalized()));
  }
  const auto high = (beyond_px.array() > kBump_ratio * circle.radius).count();
  if (static_cast<double>(high) > kMostOfOutline * static_cast<double>(outline.cols())) beyond_px.setZero();
  return beyond_px;
}

double OutOfRound::at(const Eigen::Vector2d& outward, double angle_rad) const {
  const std::complex<double> turn = std::polar(1.0, std::atan2(outward.y(), outward.x()) - angle_rad);
  std::complex<double> power = turn;
  double sum = 0.0;
  for (int m = kLowest; m <= kHighest; ++m) {
    power *= turn;
    sum += terms_(0, m - kLowest) * power.real() + terms_(1, m - kLowest) * power.imag();
  }
  return sum;
}

Eigen::Matrix2Xd OutOfRound::rounded(const Eigen::Matrix2Xd& outline, const Eigen::Vector2d& center) const {
  Eigen::Matrix2Xd points = outline;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d outward = (outline.col(i) - center).normalized();
    points.col(i) -= at(outward) * outward;
  }
  return points;
}

OutOfRound OutOfRound::turned_back(double angle_rad) const {
  OutOfRound back;
  for (int m = kLowest; m <= kHighest; ++m) {
    const double c = std::cos(m * angle_rad), s = std::sin(m * angle_rad);
    const auto term = terms_.col(m - kLowest);
    back.terms_.col(m - kLowest) << c * term[0] + s * term[1], c * term[1] - s * term[0];
  }
  return back;
}

}  // namespace pellucida
