#include "SoftZona.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

constexpr double kReach_px = 4.0;       // a frame's motion against the oolemma
constexpr double kRigidity = 400.0;     // a faint border: the neighbours must help
constexpr double kClearEvidence = 0.8;  // nats per sample that make a point certain

// Distance from `center` to a closed contour in each of `count` even directions, farthest crossing first.
double radius_towards(const Eigen::Matrix2Xd& points, const Eigen::Vector2d& center, double angle) {
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  double best = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d a = points.col(i) - center, b = points.col(i + 1 == points.cols() ? 0 : i + 1) - center;
    const double sa = direction.x() * a.y() - direction.y() * a.x();
    const double sb = direction.x() * b.y() - direction.y() * b.x();
    if ((sa <= 0.0) == (sb <= 0.0)) continue;
    best = std::max(best, direction.dot(a + sa / (sa - sb) * (b - a)));
  }
  return best;
}

}  // namespace

void SoftZona::start(const FrameSampler& image, double noise, const DetectedCell& cell, const SnakeContour& line) {
  outer_ = {};
  gap_ = {};
  if (!cell.outer.is_border || line.points.cols() == 0) return;
  const Eigen::Index n = line.points.cols();
  line_center_ = contour::centroid(line.points);
  window_px_ = 3.0 * cell.outer.scale_px;
  outer_.points = contour::resample(contour::positively_oriented(cell.outer.points), n);
  outer_.kind = cell.outer.kind;
  outer_.scale_px = cell.outer.scale_px;
  // Points first where they are, so that the smoothing acts on what was found.
  measure(image, noise, kReach_px);
  rest_radius_ = contour::fit_circle(outer_.points, 0.06 * cell.circle.radius).radius;
  if (!cell.inner || !cell.oolemma) return;
  const Eigen::Matrix2Xd inner = contour::positively_oriented(cell.inner->points);
  gap_ratio_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double whole = radius_towards(outer_.points, line_center_, angle);
    gap_ratio_[i] = whole > 0.0 ? radius_towards(inner, line_center_, angle) / whole : 0.0;
  }
  gap_.kind = cell.inner->kind;
  gap_.scale_px = cell.inner->scale_px;
  gap_.confidence = Eigen::VectorXd::Constant(n, 0.5 * cell.inner->coverage);
  gap_.sigma_px = Eigen::VectorXd::Constant(n, 3.0 * cell.inner->scale_px);
  gap_.score = 0.5 * cell.inner->coverage;
  place_gap(line);
}

void SoftZona::follow(const FrameSampler& image, double noise, const SnakeContour& line) {
  if (!valid()) return;
  const Eigen::Vector2d center = contour::centroid(line.points), moved = center - line_center_;
  line_center_ = center;
  outer_.points.colwise() += moved;
  outer_.points = contour::resample(outer_.points, outer_.points.cols());
  measure(image, noise, kReach_px);
  if (has_gap()) place_gap(line);
}

// The outer edge within `reach_px` of where it was last; outside the image the rigidity bridges.
void SoftZona::measure(const FrameSampler& image, double noise, double reach_px) {
  constexpr double kStep_px = 1.0;
  const Eigen::Index n = outer_.points.cols();
  const int reach = static_cast<int>(std::lround(reach_px / kStep_px));
  const Eigen::Matrix2Xd normals = contour::outward_normals(outer_.points);
  border_.sample(image, outer_.points, normals, reach_px, reach_px, kStep_px, window_px_);
  border_.evidence(static_cast<int>(n) / 24, noise, evidence_);
  const std::vector<int> middle(static_cast<std::size_t>(n), reach);
  border_.split(middle, reach, static_cast<int>(n) / 48, noise, likelihood_);

  Eigen::VectorXd edges(n), weights(n);
  const Eigen::VectorXd rigidity = Eigen::VectorXd::Constant(n, kRigidity);
  outer_.confidence.resize(n);
  outer_.sigma_px.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Index best = 0;
    likelihood_.row(i).maxCoeff(&best);
    edges[i] = border_.offset_of(static_cast<double>(best));
    const double clear = std::clamp(static_cast<double>(evidence_.row(i).maxCoeff()) / kClearEvidence, 0.0, 1.0);
    const bool inside = border_.inside(static_cast<int>(i), reach);
    weights[i] = inside ? clear : 0.0;
    outer_.confidence[i] = inside ? clear : 0.1;
  }
  const Eigen::VectorXd& u = snake_.relax(outer_.points, normals, edges, weights, rigidity, 0.0);

  // What neighbours disagree is what the border's place is uncertain by.
  double score = 0.0, seen = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    double squares = 0.0, weight = 0.0;
    for (Eigen::Index k = -8; k <= 8; ++k) {
      const Eigen::Index j = contour::wrap(i + k, n);
      squares += weights[j] * (u[j] - edges[j]) * (u[j] - edges[j]);
      weight += weights[j];
    }
    outer_.sigma_px[i] = weight > 0.0 ? 0.5 + std::sqrt(squares / weight) : window_px_;
    if (weights[i] <= 0.0) continue;
    score += weights[i];
    seen += 1.0;
  }
  outer_.score = seen > 0.0 ? score / seen : 0.0;
  for (Eigen::Index i = 0; i < n; ++i) outer_.points.col(i) += std::clamp(u[i], -reach_px, reach_px) * normals.col(i);
}

// Between the two others: never inside the oolemma.
void SoftZona::place_gap(const SnakeContour& line) {
  const Eigen::Index n = gap_ratio_.size();
  gap_.points.resize(2, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = std::max(gap_ratio_[i] * radius_towards(outer_.points, line_center_, angle),
                                   radius_towards(line.points, line_center_, angle));
    gap_.points.col(i) = line_center_ + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
}

}  // namespace pellucida
