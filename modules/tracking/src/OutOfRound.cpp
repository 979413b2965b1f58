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
// Of the radius: a circle farther from the middle of an outline has settled on one side of it; what an oval has of the
// higher harmonics; a limb that is taken for a part of the outline has more.
constexpr double kOffMiddle_ratio = 0.06, kMostBesideOval_ratio = 0.05;
constexpr double kMostOfOutline = 0.4;  // that bumps take; an outline with more of them is not that of an oval

constexpr Eigen::Index kTerms = 2 * OutOfRound::kHighest + 1;  // mean, cosine and sine of the first to the highest
using Harmonics = Eigen::Matrix<double, kTerms, 1>;

// Of how far the outline lies beyond the circle, and what they leave of it (RMS).
Harmonics harmonics_of(const Eigen::Matrix2Xd& outline, const contour::Circle& circle, double& misfit_px) {
  const Eigen::Index n = outline.cols();
  Eigen::Matrix<double, Eigen::Dynamic, kTerms> rows(n, kTerms);
  Eigen::VectorXd beyond(n), weight = Eigen::VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector2d d = outline.col(i) - circle.center;
    const double angle = std::atan2(d.y(), d.x());
    beyond[i] = d.norm() - circle.radius;
    rows(i, 0) = 1.0;
    for (int m = 1; m <= OutOfRound::kHighest; ++m) {
      rows(i, 2 * m - 1) = std::cos(m * angle);
      rows(i, 2 * m) = std::sin(m * angle);
    }
  }
  Harmonics fitted = Harmonics::Zero();
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Matrix<double, kTerms, kTerms> normal = rows.transpose() * weight.asDiagonal() * rows;
    fitted = normal.ldlt().solve(rows.transpose() * weight.asDiagonal() * beyond);
    if (!fitted.allFinite()) return fitted;
    const Eigen::VectorXd off = beyond - rows * fitted;
    misfit_px = std::sqrt(off.squaredNorm() / static_cast<double>(n));
    if (round + 1 < kPlainRounds) continue;
    weight = (1.0 + (off / kScale_px).array().square()).inverse();
  }
  return fitted;
}

}  // namespace

OutOfRound OutOfRound::of(const Eigen::Matrix2Xd& outline, const contour::Circle& circle) {
  return fit(outline, circle).shape;
}

OutOfRound::Fit OutOfRound::fit(const Eigen::Matrix2Xd& outline, const contour::Circle& circle, int moves) {
  Fit unmoved{circle, {}, 0.0};
  if (outline.cols() < kFewest || circle.radius <= 0.0) return unmoved;
  Fit result = unmoved;
  for (int move = 0; move <= moves; ++move) {
    const Harmonics fitted = harmonics_of(outline, result.circle, result.misfit_px);
    if (!fitted.allFinite()) break;
    const Eigen::Vector2d off = fitted.segment<2>(1);
    for (int m = kLowest; m <= kHighest; ++m) result.shape.terms_.col(m - kLowest) << fitted[2 * m - 1], fitted[2 * m];
    const Eigen::RowVectorXd sizes = result.shape.terms_.colwise().norm() / result.circle.radius;
    const bool is_cell = sizes.sum() <= kMost_ratio,
               is_oval = sizes.tail(sizes.size() - 1).sum() <= kMostBesideOval_ratio;
    const bool is_in_middle = off.norm() <= kOffMiddle_ratio * circle.radius;
    if (is_cell && is_in_middle && (move == 0 || is_oval)) return result;
    if (move == 0) {
      unmoved.misfit_px = result.misfit_px;
      if (is_cell) unmoved.shape = result.shape;
    }
    result.circle.center += off;
    result.circle.radius += fitted[0];
  }
  return unmoved;
}

Eigen::VectorXd OutOfRound::bumps(const Eigen::Matrix2Xd& outline, const contour::Circle& circle) {
  const Fit oval = fit(outline, circle, 0);
  Eigen::VectorXd beyond_px(outline.cols());
  for (Eigen::Index i = 0; i < outline.cols(); ++i) {
    const Eigen::Vector2d d = outline.col(i) - oval.circle.center;
    beyond_px[i] = std::max(0.0, d.norm() - oval.circle.radius - oval.shape.at(d.normalized()));
  }
  const auto high = (beyond_px.array() > kBump_ratio * oval.circle.radius).count();
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
