// The pair of snakes by the distance between them: the zona's thickness, learnt and used.
#include <algorithm>
#include <cmath>

#include "ContourMath.h"
#include "MembraneSnakes.h"

namespace pellucida {
namespace {

constexpr double kLeastThicknessSpread = 0.04;  // of the thickness: a zona is not more even than that
constexpr double kApart = 3.0;     // sigmas between an edge and where the thickness has it, at which its own doubles
constexpr double kSqueeze = 0.25;  // of the zona's thickness that the tip may take away

}  // namespace

// Distance of each outer point from the inner contour: both run the same way round, so the nearest place moves on
// steadily.
void MembraneSnakes::measure_gaps() {
  const Eigen::Index n = outer_.points.cols(), m = inner_.points.cols();
  gaps_.resize(n);
  gap_places_.resize(static_cast<std::size_t>(n));
  Eigen::Index nearest = 0;
  const auto distance = [&](Eigen::Index i, Eigen::Index j) {
    return (outer_.points.col(i) - inner_.points.col(contour::wrap(j, m))).squaredNorm();
  };
  for (Eigen::Index j = 1; j < m; ++j)
    if (distance(0, j) < distance(0, nearest)) nearest = j;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = nearest;
    double best = distance(i, from);
    for (Eigen::Index j = from - 4; j <= from + 8; ++j) {
      const double d = distance(i, j);
      if (d >= best) continue;
      best = d;
      nearest = j;
    }
    nearest = contour::wrap(nearest, m);
    gap_places_[static_cast<std::size_t>(i)] = nearest;
    // To the two chords that meet there.
    const Eigen::Vector2d p = outer_.points.col(i), a = inner_.points.col(nearest);
    for (const Eigen::Index k : {nearest - 1, nearest + 1}) {
      const Eigen::Vector2d chord = inner_.points.col(contour::wrap(k, m)) - a;
      const double t = std::clamp(chord.dot(p - a) / std::max(chord.squaredNorm(), 1e-12), 0.0, 1.0);
      best = std::min(best, (p - a - t * chord).squaredNorm());
    }
    gaps_[i] = std::sqrt(best);
  }
}

void MembraneSnakes::learn_thickness(const NeedleZone* needle, double share) {
  measure_gaps();
  sorted_.clear();
  for (Eigen::Index i = 0; i < gaps_.size(); ++i)
    if (!needle || !needle->covers(outer_.points.col(i), 6.0)) sorted_.push_back(gaps_[i]);
  if (sorted_.empty()) return;
  const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
  std::nth_element(sorted_.begin(), middle, sorted_.end());
  const double thickness = *middle;
  for (double& gap : sorted_) gap = std::abs(gap - thickness);
  const auto spread = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() * 3 / 4);
  std::nth_element(sorted_.begin(), spread, sorted_.end());
  thickness_ += share * (thickness - thickness_);
  thickness_sigma_ += share * (std::max(*spread, kLeastThicknessSpread * thickness) - thickness_sigma_);
}

// The zona's thickness says where the outer membrane is when the inner one is seen and it itself is not.
void MembraneSnakes::use_thickness(const NeedleZone* needle) {
  measure_gaps();
  const Eigen::Index n = outer_.points.cols(), m = inner_.points.cols();
  const auto match = static_cast<double>(m) / static_cast<double>(inner_.sigma_px.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto place = static_cast<Eigen::Index>(gap_places_[static_cast<std::size_t>(i)] / match);
    // Under the tip a zona may be squeezed.
    double squeezed = 0.0;
    if (needle && needle->touching) {
      const double t = (outer_.points.col(i) - needle->tip).norm() / (3.0 * needle->tip_half_width + 8.0);
      if (t < 4.0) squeezed = kSqueeze * thickness_ * std::exp(-0.5 * t * t);
    }
    const double sigma = std::hypot(std::hypot(thickness_sigma_, squeezed),
                                    inner_.sigma_px[std::min(place, inner_.sigma_px.size() - 1)]);
    // An edge that lies elsewhere than the thickness allows is another body's.
    const double expected = thickness_ - gaps_[i], apart = (edges_[i] - expected) / (kApart * (sigma + sigmas_[i]));
    const double own = sigmas_[i] * (1.0 + apart * apart);
    const double a = 1.0 / (own * own), b = 1.0 / (sigma * sigma);
    edges_[i] = (a * edges_[i] + b * expected) / (a + b);
    sigmas_[i] = 1.0 / std::sqrt(a + b);
  }
}

}  // namespace pellucida
