#include "CellFollower.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ContourMath.h"
#include "Median.h"

namespace pellucida {
namespace {

constexpr double kCircleTolerance_px = 3.0;
// A centre so far (of the radius) from another is another one.
constexpr double kElsewhere_ratio = 0.08;
// Of the narrow band: where a membrane that is back at rest is looked for.
constexpr double kAtRest_ratio = 0.5;
// Of an outline's area, what is left of it in the next frame at least.
constexpr double kKeptArea_ratio = 0.9;
// Of the radius: what a zona's thickness is supposed to be where the boundaries don't show it.
constexpr double kUsualZona_ratio = 0.1;

}  // namespace

contour::Circle CellFollower::circle_of(const Eigen::Matrix2Xd& points) {
  return contour::fit_circle(points, kCircleTolerance_px);
}

// The pixels of the holder, outside the cell: they show the cell's rigid motion. Its rim is what shows a motion along
// the pipette, so the pixels go close to the membrane and not far up the shaft.
void CellFollower::learn_holder_motion(const FrameInput& frame) {
  rigid_.reset();
  beside_walls_.setZero();
  walls_slid_px2_ = 0.0;
  if (!holder_) return;
  const Eigen::Vector2d across(-holder_->direction.y(), holder_->direction.x());
  std::vector<Eigen::Vector2d> points;
  const double half = holder_->half_width + 6.0;
  const double cell_radius = resting_circle().radius;
  for (double s = 0.7 * cell_radius; s < 1.6 * cell_radius; s += 1.0) {
    for (double v = holder_->offset - half; v <= holder_->offset + half; v += 1.0) {
      if (std::hypot(s, v) < cell_radius + 3.0) continue;
      points.push_back(rest_.center + s * holder_->direction + v * across);
    }
  }
  rigid_.learn(frame.image, points, rest_.center, frame.noise);
}

void CellFollower::learn_rest(const FrameInput& frame) {
  const Eigen::Matrix2Xd& points = snakes_.outer().points;
  const OutOfRound::Fit oval = OutOfRound::fit(points, circle_of(points));
  const auto round = [&](const SnakeContour& snake) {
    return circle_of(oval.shape.rounded(snake.points, oval.circle.center));
  };
  const contour::Circle outer = round(snakes_.outer());
  const double inner_radius = snakes_.has_inner() ? round(snakes_.inner()).radius : 0.0;
  const bool elsewhere = (outer.center - center_now()).norm() > kElsewhere_ratio * rest_.outer_radius;
  if (outer.inlier_ratio < 0.6 || inner_radius >= outer.radius || elsewhere) return;
  rest_.learn(motion_.undo(outer.center), outer.radius, inner_radius, oval.shape.turned_back(motion_.angle_rad),
              outer_sigma());
  read_thickness(frame);
  if (snakes_.has_inner() || zona_.valid() || rest_.thin_zona.is_full()) return;
  const NeedleZone needle_zone = zone();
  rest_.thin_zona.add(ThinZona::read(frame.image, points, snakes_.outer().kind, snakes_.line_width_px(),
                                     needle_.valid() ? &needle_zone : nullptr));
}

// By the network that looks at all sides of the cell at once: from what it said before, from what the boundaries say,
// or from a usual zona.
void CellFollower::read_thickness(const FrameInput& frame) {
  if (!is_read_ || rest_.read_thickness.is_full()) return;
  double supposed_px = snakes_.has_inner() ? snakes_.thickness_px() : kUsualZona_ratio * rest_.outer_radius;
  if (rest_.read_thickness.is_read()) supposed_px = rest_.read_thickness.mean_px();
  rest_.read_thickness.add(frame.reader->thicknesses().read(frame.image, snakes_.outer().points, supposed_px));
}

// Usual standard deviation of a place of the outer contour, px; 0 of one that follows lines.
double CellFollower::outer_sigma() const {
  if (!is_read_) return 0.0;
  const Eigen::VectorXd& sigma_px = snakes_.outer().sigma_px;
  std::vector<double> sorted(sigma_px.begin(), sigma_px.end());
  return median_of(sorted);
}

// Mean confidence of a contour on the needle's side, where a dimple is or is not.
double CellFollower::local_score(const SnakeContour& snake) const {
  if (!needle_.valid()) return snake.score;
  const NeedleZone needle_zone = zone();
  double sum = 0.0, count = 0.0;
  for (Eigen::Index i = 0; i < snake.points.cols(); ++i) {
    const Eigen::Vector2d d = snake.points.col(i) - needle_zone.tip;
    const double across = std::abs(needle_zone.direction.x() * d.y() - needle_zone.direction.y() * d.x());
    if (across > 0.45 * rest_.outer_radius || d.dot(needle_zone.direction) > 0.8 * rest_.outer_radius) continue;
    if (needle_zone.covers(snake.points.col(i), 2.0)) continue;
    sum += snake.confidence[i];
    count += 1.0;
  }
  return count > 3.0 ? sum / count : snake.score;
}

double CellFollower::local_score() const {
  const double outer = local_score(snakes_.outer());
  return snakes_.has_inner() ? std::min(outer, local_score(snakes_.inner())) : outer;
}

// Either contour as a whole, the weaker one.
double CellFollower::whole_score() const {
  return snakes_.has_inner() ? std::min(snakes_.outer().score, snakes_.inner().score) : snakes_.outer().score;
}

// The weakest of what was seen: either contour as a whole, and on the needle's side.
double CellFollower::quality_now() const {
  return std::min(whole_score(), local_score());
}

// The narrow band first; where that fails, wider, and with the membrane sprung back.
void CellFollower::follow_contours(const FrameInput& frame, const Eigen::Vector2d& shift) {
  const PartTimer timer(frame.timings->contours_us);
  const NeedleZone needle_zone = zone();
  const NeedleZone* known = needle_.valid() ? &needle_zone : nullptr;
  NeedleZone loose = needle_zone;
  loose.touching = false;
  outer_before_ = snakes_.outer();
  inner_before_ = snakes_.inner();
  if (is_read_) {
    read_boundaries(frame, known, shift);
    return;
  }
  snakes_.track(frame.image, frame.noise, shift, tip_way(), known, options_.search_px);
  quality_ = quality_now();
  if (contact_.state() == CellState::kPunctured || (touching_ && (are_flanks_back() || is_seen_through())))
    follow_unpushed(frame, known ? &loose : nullptr);
  const double usual = std::max(0.6, 0.88 * usual_quality_);
  if (quality_ >= usual) return;
  // At rest, and seen as ever but beside a needle that does not touch yet: its tip is what hides the membrane there.
  if (known && !touching_ && whole_score() >= usual && lies_at_rest(snakes_.outer())) return;

  SnakeContour best_outer = snakes_.outer(), best_inner = snakes_.inner();
  const auto attempt = [&](const NeedleZone* with, bool from_rest, double reach) {
    snakes_.restore(outer_before_, inner_before_);
    if (from_rest)
      snakes_.restore(at_rest(outer_before_, rest_.outer_radius), at_rest(inner_before_, rest_.inner_radius));
    snakes_.track(frame.image, frame.noise, from_rest ? Eigen::Vector2d::Zero() : shift, tip_way(), with, reach);
    const double now = quality_now();
    if (now > quality_ + 0.05 && keeps_area() && !(touching_ && cuts_dimple())) {
      quality_ = now;
      best_outer = snakes_.outer();
      best_inner = snakes_.inner();
    }
  };
  attempt(known, false, options_.wide_search_px);
  if (known && touching_) {
    attempt(&loose, false, options_.wide_search_px);
    // Close to rest first: further off the snake may go over to a stronger line, the oolemma's.
    attempt(&loose, true, kAtRest_ratio * options_.search_px);
    attempt(&loose, true, 2.0 * options_.search_px);
    attempt(&loose, true, options_.wide_search_px);
  } else if (!lies_at_rest(best_outer)) {
    attempt(known, true, options_.wide_search_px);
  }
  snakes_.restore(best_outer, best_inner);
}

// A membrane that has given way is at rest, but the edges of the needle that is through may hold the contour in the
// dimple: where it is seen at rest about as well, that is where it is.
void CellFollower::follow_unpushed(const FrameInput& frame, const NeedleZone* needle) {
  measure_dent();
  if (new_dent_ratio() < kUnpushedDent_ratio || measure_membrane_depth() < kOnTip_ratio * tip_depth()) return;
  const SnakeContour outer = snakes_.outer(), inner = snakes_.inner();
  snakes_.restore(at_rest(outer_before_, rest_.outer_radius), at_rest(inner_before_, rest_.inner_radius));
  snakes_.track(frame.image, frame.noise, Eigen::Vector2d::Zero(), tip_way(), needle,
                kAtRest_ratio * options_.search_px);
  const double at_rest_quality = quality_now();
  if (at_rest_quality > kAsWell_ratio * quality_) {
    quality_ = at_rest_quality;
  } else {
    snakes_.restore(outer, inner);
  }
}

bool CellFollower::follow(const FrameInput& frame) {
  ++frames_followed_;
  const std::optional<Eigen::Vector2d> jump = notice_jump(frame);
  const Eigen::Vector2d center_before = center_now();
  follow_rigid_motion(frame, jump.value_or(Eigen::Vector2d::Zero()));
  drift_.advance(jump ? Eigen::Vector2d(center_now() - center_before) : Eigen::Vector2d::Zero());
  if (frame.command) frame.command->move_scene(center_now() - center_before);
  // The holder's fit says better than the picture as a whole how far a jump went.
  const Eigen::Vector2d shift = center_now() - center_before;
  scene_jump_ = jump ? shift : Eigen::Vector2d::Zero();
  follow_needle(frame, shift);

  const bool punctured = contact_.state() == CellState::kPunctured;
  touching_ = needle_.valid() && !punctured && tip_depth() > 0.5;
  read_puncture(frame);
  follow_contours(frame, center_now() - center_before);
  const bool good = snakes_.outer().score >= options_.min_tracking_score && plausible();
  bad_frames_ = good ? 0 : bad_frames_ + 1;
  if (!good) {
    snakes_.restore(outer_before_, inner_before_);
    return bad_frames_ < options_.lost_after_frames;
  }

  zona_.follow(frame.image, frame.noise, snakes_.outer());
  usual_quality_ += 0.1 * (quality_ - usual_quality_);
  // Far worse than when the cell was found, frame after frame: something else is followed.
  poor_frames_ = quality_ < 0.55 * first_quality_ ? poor_frames_ + 1 : 0;
  if (poor_frames_ >= 2 * options_.lost_after_frames) return false;

  check_rigid_motion(frame, center_before, jump.value_or(Eigen::Vector2d::Zero()));
  membrane_depth_ = measure_membrane_depth();
  take_dimple();
  follow_flanks();
  if (!are_flanks_back()) needle_.believe_reading();
  const bool was_free = contact_.state() == CellState::kFree;
  contact_.update({needle_.valid() ? tip_depth() : -1e3, membrane_depth_, needle_.valid(), depth_sigma(),
                   needle_.valid() ? needle_.estimate().tip_sigma : 0.0, is_pushed(), past_sigma()});
  if (was_free && contact_.state() == CellState::kContact && zone().is_shade) needle_.rest_on(apex(), apex_sigma());
  if (!may_be_pushed()) {
    drift_.learn(center_now());
    learn_rest(frame);
  }
  measure_dent();
  check_holder_by_outline(frame);
  watch_facing(frame);
  return true;
}

SnakeContour CellFollower::at_rest(const SnakeContour& like, double radius_px) const {
  SnakeContour result = like;
  if (like.points.cols() == 0 || radius_px <= 0.0) return result;
  const Eigen::Index n = like.points.cols();
  for (Eigen::Index i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    const Eigen::Vector2d outward(std::cos(angle), std::sin(angle));
    result.points.col(i) = center_now() + (radius_px + rest_.shape.at(outward, motion_.angle_rad)) * outward;
  }
  return result;
}

// Nowhere further from the outline at rest than what is searched about that first.
bool CellFollower::lies_at_rest(const SnakeContour& outer) const {
  for (Eigen::Index i = 0; i < outer.points.cols(); ++i) {
    const Eigen::Vector2d from_center = outer.points.col(i) - center_now();
    const double distance_px = from_center.norm();
    const double rest_px = rest_.outer_radius + rest_.shape.at(from_center / distance_px, motion_.angle_rad);
    if (!(std::abs(distance_px - rest_px) < kAtRest_ratio * options_.search_px)) return false;
  }
  return true;
}

// From one frame to the next a cell is not dented so deep that its outline loses a tenth of its area: the contour would
// have gone over to an edge within, the zona's inner one or the oolemma.
bool CellFollower::keeps_area() const {
  return contour::signed_area(snakes_.outer().points) > kKeptArea_ratio * contour::signed_area(outer_before_.points);
}

// A contour that encloses far too little or too much, or crosses itself, is none.
bool CellFollower::plausible() const {
  const Eigen::Matrix2Xd& points = snakes_.outer().points;
  const double area = contour::signed_area(points), rest = M_PI * rest_.outer_radius * rest_.outer_radius;
  return area > 0.5 * rest && area < 1.4 * rest && keeps_area() && !contour::self_intersects(points);
}

}  // namespace pellucida
