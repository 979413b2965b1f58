// The pair of snakes on edges that a network reads along their normals, instead of on a look learnt from the film.
#include <algorithm>
#include <cmath>

#include "BoundaryNetwork.h"
#include "ContourMath.h"
#include "Median.h"
#include "MembraneSnakes.h"
#include "OutOfRound.h"

namespace pellucida {
namespace {

// Of the radius: no place is known better than this.
constexpr double kLeastSpreadShare = 0.0015;
// Spread, of the radius, of an inner boundary that is not seen any more.
constexpr double kUnseenShare = 0.05;
// The same of one that is another edge's.
constexpr double kAnotherShare = 0.2;
// Of the radius: two boundaries this near to each other are one.
constexpr double kOneShare = 0.03;
constexpr double kThicknessShare = 0.1;  // of the thickness, learnt anew with each reading
// px, and `OutOfRound::kBump_ratio`: an edge so far outside the oval, or, of a pushed outline, outside the others to
// either side within this part of it, is that of a body that lies on the membrane, as cumulus cells do. No membrane
// bulges so away from the side, within this cosine, that a needle pushes.
constexpr double kLeastBump_px = 3.0, kPushedSide_cos = 0.7;
constexpr Eigen::Index kBumpWindow = 8;
// Stiffness: where nothing pushes, the snake resists all bending, and bridges what a holding pipette hides; within so
// many radii of a tip that pushes, only what the shape has not had.
constexpr double kReadRigidity = 20.0, kDimpleRadii = 1.0;

// Of the radius: an outline that is as near to what was read needs no further round.
constexpr double kSettledShare = 0.003;
constexpr int kRoundsAtFirst = 6;  // from a rough outline

// The places of the network's normals on others of the same contour, both evenly spaced from the same point on.
void spread_out(const Eigen::VectorXd& places, Eigen::VectorXd& out) {
  const double ratio = static_cast<double>(places.size()) / static_cast<double>(out.size());
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const double at = ratio * static_cast<double>(i);
    const auto whole = static_cast<Eigen::Index>(at);
    const double t = at - static_cast<double>(whole);
    out[i] = (1.0 - t) * places[whole] + t * places[contour::wrap(whole + 1, places.size())];
  }
}

}  // namespace

void MembraneSnakes::distrust_bumps(double radius_px, const NeedleZone* needle) {
  const Eigen::Index n = edges_.size(), reach = n / kBumpWindow;
  const double height_px = std::max(kLeastBump_px, OutOfRound::kBump_ratio * radius_px);
  const Eigen::Vector2d center = outer_.points.rowwise().mean();
  const bool is_entered = needle && (needle->tip - center).norm() < radius_px;
  if (!is_entered) {
    even_ = outer_.points + normals_ * edges_.asDiagonal();
    const Eigen::VectorXd bump_px = OutOfRound::bumps(even_, contour::fit_circle(even_, height_px));
    for (Eigen::Index i = 0; i < n; ++i) {
      if (bump_px[i] < height_px) continue;
      edges_[i] -= bump_px[i];
      sigmas_[i] = kAnotherShare * radius_px;
    }
    return;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    if ((outer_.points.col(i) - center).normalized().dot(-needle->direction) > kPushedSide_cos) continue;
    sorted_.clear();
    for (Eigen::Index k = i - reach; k <= i + reach; ++k) sorted_.push_back(edges_[contour::wrap(k, n)]);
    const double about_px = median_of(sorted_);
    if (edges_[i] < about_px + height_px) continue;
    edges_[i] = about_px;
    sigmas_[i] = kAnotherShare * radius_px;
  }
}

void MembraneSnakes::relax_on(const BoundaryPlaces& places, bool is_outer, double radius_px, const NeedleZone* needle,
                              SnakeContour& snake) {
  const Eigen::Index n = outer_.points.cols();
  edges_.resize(n);
  sigmas_.resize(n);
  spread_out(places.offset_px, edges_);
  spread_out(places.sigma_px, sigmas_);
  sigmas_ = sigmas_.cwiseMax(kLeastSpreadShare * radius_px);
  distrust_bumps(radius_px, needle);
  rigidity_.setConstant(n, kReadRigidity);
  shape_share_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const bool pushed =
        needle && needle->touching && (outer_.points.col(i) - needle->tip).norm() < kDimpleRadii * radius_px;
    shape_share_[i] = pushed ? kShapeShare : 1.0;
    if (is_outer && pushed && std::abs(edges_[i]) > needle->trust_px) sigmas_[i] = kAnotherShare * radius_px;
  }
  snake.confidence = confidence_of(sigmas_, radius_px);
  double score = 0.0, seen = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (needle && needle->covers(outer_.points.col(i), kNeedleMargin)) continue;
    score += snake.confidence[i];
    seen += 1.0;
  }
  snake.score = seen > 0.0 ? score / seen : 0.0;
  if (is_outer && needle) use_needle(snake, true, *needle);
  rigidity_ = rigidity_.cwiseMin(kReadRigidity);
  // The weight of 1 belongs to an edge as sure as most.
  const Eigen::VectorXd& u = snake_.relax(outer_.points, normals_, edges_, sigmas_, rigidity_, shape_share_,
                                          {options_.elasticity, 3.0 * kLeastSpreadShare * radius_px});
  even_ = outer_.points + normals_ * u.asDiagonal();
  if (is_outer) moved_px_ = std::sqrt(u.squaredNorm() / static_cast<double>(n));
  const Eigen::VectorXd& deviation = snake_.deviation(edges_);
  snake.sigma_px = deviation.cwiseMax(kLeastSpreadShare * radius_px);
  snake.points = even_;
}

bool MembraneSnakes::start(const FrameSampler& image, BoundaryNetwork& network, const Eigen::Matrix2Xd& outline,
                           double share, const NeedleZone* needle, double least_score) {
  outer_ = inner_ = {};
  outer_look_ = inner_look_ = {};
  thickness_ = 0.0;
  if (outline.cols() < 3) return false;
  outer_.points = contour::resample(contour::positively_oriented(outline), options_.contour_point_count);
  sureness_ = read(image, network, needle, kRoundsAtFirst) * share;
  return outer_.score >= least_score;
}

double MembraneSnakes::read(const FrameSampler& image, BoundaryNetwork& network, const NeedleZone* needle, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    contour::resample_smooth(outer_.points, options_.contour_point_count, 0.0, even_);
    outer_.points.swap(even_);
    const BoundaryReading reading = network.read(image, outer_.points);
    contour::outward_normals(outer_.points, normals_);
    const double radius_px = std::sqrt(std::abs(contour::signed_area(outer_.points)) / M_PI);
    const double inner_spread = reading.inner.sigma_px.mean();
    const bool shows_inner = inner_spread < kUnseenShare * radius_px &&
                             (reading.outer.offset_px - reading.inner.offset_px).mean() > kOneShare * radius_px;
    if (shows_inner) relax_on(reading.inner, false, radius_px, needle, inner_);
    relax_on(reading.outer, true, radius_px, needle, outer_);
    if (!shows_inner) inner_ = {};
    if (reading.outer.offset_px.cwiseAbs().mean() < kSettledShare * radius_px) break;
  }
  if (has_inner()) {
    contour::untie(inner_.points);  // normals of the outer one may cross on their way there
    contour::resample_smooth(inner_.points, options_.contour_point_count, 0.0, even_);
    inner_.points.swap(even_);
    learn_thickness(needle, thickness_ > 0.0 ? kThicknessShare : 1.0);
  }
  return outer_.score;
}

void MembraneSnakes::keep_reading(const FrameSampler& image) {
  const auto keep = [&](const SnakeContour& snake, BoundaryMotion& motion, Eigen::VectorXd& sigma_px) {
    motion.set(image, snake.points);
    sigma_px = snake.sigma_px;
  };
  keep(outer_, outer_motion_, outer_read_sigma_px_);
  if (has_inner()) keep(inner_, inner_motion_, inner_read_sigma_px_);
}

bool MembraneSnakes::go_on(const FrameSampler& image, double noise, const NeedleZone* needle) {
  if (!outer_motion_.find(image, outer_.points, noise, needle)) return false;
  if (has_inner() && !inner_motion_.find(image, inner_.points, noise, needle)) return false;
  const auto move = [](const BoundaryMotion& motion, const Eigen::VectorXd& read_sigma_px, SnakeContour& snake) {
    snake.points += motion.normals() * motion.shift_px().asDiagonal();
    snake.sigma_px = (read_sigma_px.array().square() + motion.variance_px2().array()).sqrt();
  };
  move(outer_motion_, outer_read_sigma_px_, outer_);
  if (has_inner()) move(inner_motion_, inner_read_sigma_px_, inner_);
  return true;
}

}  // namespace pellucida
