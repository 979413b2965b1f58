#include "CellFollower.h"

#include <algorithm>
#include <cmath>

#include "ContourMath.h"

namespace pellucida {
namespace {

constexpr double kCircleTolerance_px = 3.0;
// A tip that far outside the resting outline touches nothing.
constexpr double kAway_px = 2.0;
// How far the holder may move between two frames, the search for it included.
constexpr double kRigidReach_px = 38.0;
// The seat so far (of the radius, and px) from where the holder puts it, at once: the holder is not to be trusted; or so
// far, px and of the radius, for so many frames. On 25 films with a holder (validation 22001 to 22040) the seat was within
// 1.7 px of the truth, the walls within 2.5 px in 24 and 12 px off in one.
constexpr double kAstray_ratio = 0.08, kJump_ratio = 0.03, kLeastJump_px = 1.5;
constexpr double kSlid_px = 2.0, kSlid_ratio = 0.03;
constexpr int kAstrayFrames = 3, kMostAstray = 1;
// Walls that are so far from an untouched cell's place along the pipette, px, in the mean of late, don't tell where it
// is; how that mean follows, per frame.
constexpr double kSlips_px = 0.5, kSlipPace = 0.3;
// Within so much (cosine) of the holder's direction the membrane stays on its mouth; where no holder is known, more of
// it has to do. Rounds of the fit; its scale at first and last.
constexpr double kSeatCosine = 0.85, kFarCosine = 0.5;
constexpr int kSeatRounds = 12;
constexpr double kSeatReach_px = 8.0, kSeatScale_px = 2.0;
// Standard deviations of the seat where no holder's walls show the motion: px, by the whole outline and in contact, and
// of the needle's depth, which dents the one and, without a holder in view, bulges the far side of the other; how far
// from its drift a cell has moved. Without: a holder beside the needle's line lets the far side go by 0.41 of a push of
// 25 um (wide film 179137).
constexpr double kOutlineSigma_px = 0.1, kSeatSigma_px = 0.45;
constexpr double kDent_ratio = 0.2, kBulge_ratio = 0.4, kMoved_sigmas = 3.0;
// A holder lets its seat go by towards it, by this share of the needle's depth times a power of its radius over the
// cell's; how much that differs, over itself, and of the depth. By the walls of 568 specimens (3101 to 3937) pushed by
// 0.15 R and more: 0.07 of the depth at 0.17 R, 0.034 at 0.22, 0.011 at 0.35, 90 % of them within 0.6 to 1.5 of that.
constexpr double kSeatWay_ratio = 0.0013, kSeatWayPower = -2.2, kNarrowest_ratio = 0.12;
constexpr double kSeatWaySigma_ratio = 0.4, kDepthSigma_ratio = 0.01;
// Of the outline of a cell that networks read; of where the walls put it.
constexpr double kReadSigma_px = 0.25, kWallsSigma_px = 0.1;
// Of the narrow band: where a membrane that is back at rest is looked for.
constexpr double kAtRest_ratio = 0.5;
// Of the tip's depth: the contour lies on it.
constexpr double kOnTip_ratio = 0.85;
// Of an outline's area, what is left of it in the next frame at least.
constexpr double kKeptArea_ratio = 0.9;

}  // namespace

contour::Circle CellFollower::circle_of(const Eigen::Matrix2Xd& points) {
  return contour::fit_circle(points, kCircleTolerance_px);
}

// The pixels of the holder, outside the cell: they show the cell's rigid motion. Its rim is what shows a motion along
// the pipette, so the pixels go close to the membrane and not far up the shaft.
void CellFollower::learn_holder_motion(const FrameInput& frame) {
  rigid_.reset();
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
  const OutOfRound shape = OutOfRound::of(snakes_.outer().points, circle_of(snakes_.outer().points));
  const auto round = [&](const SnakeContour& snake) { return circle_of(shape.rounded(snake.points, center_now())); };
  const contour::Circle outer = round(snakes_.outer());
  const double inner_radius = snakes_.has_inner() ? round(snakes_.inner()).radius : 0.0;
  const bool elsewhere = (outer.center - center_now()).norm() > kAstray_ratio * rest_.outer_radius;
  if (outer.inlier_ratio < 0.6 || inner_radius >= outer.radius || elsewhere) return;
  rest_.learn(motion_.undo(outer.center), outer.radius, inner_radius, shape.turned_back(motion_.angle_rad));
  if (snakes_.has_inner() || zona_.valid() || rest_.thin_zona.is_full()) return;
  const NeedleZone needle_zone = zone();
  rest_.thin_zona.add(ThinZona::read(frame.image, snakes_.outer().points, snakes_.outer().kind, snakes_.line_width_px(),
                                     needle_.valid() ? &needle_zone : nullptr));
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

// The weakest of what was seen: either contour as a whole, and on the needle's side.
double CellFollower::quality_now() const {
  const double both =
      snakes_.has_inner() ? std::min(snakes_.outer().score, snakes_.inner().score) : snakes_.outer().score;
  return std::min(both, local_score());
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
  snakes_.track(frame.image, frame.noise, shift, needle_.motion(), known, options_.search_px);
  quality_ = quality_now();
  if (contact_.state() == CellState::kPunctured || (touching_ && are_flanks_back()))
    follow_unpushed(frame, known ? &loose : nullptr);
  if (quality_ >= std::max(0.6, 0.88 * usual_quality_)) return;

  SnakeContour best_outer = snakes_.outer(), best_inner = snakes_.inner();
  const auto attempt = [&](const NeedleZone* with, bool from_rest, double reach) {
    snakes_.restore(outer_before_, inner_before_);
    if (from_rest)
      snakes_.restore(at_rest(outer_before_, rest_.outer_radius), at_rest(inner_before_, rest_.inner_radius));
    snakes_.track(frame.image, frame.noise, from_rest ? Eigen::Vector2d::Zero() : shift, needle_.motion(), with, reach);
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
  } else {
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
  snakes_.track(frame.image, frame.noise, Eigen::Vector2d::Zero(), needle_.motion(), needle,
                kAtRest_ratio * options_.search_px);
  const double at_rest_quality = quality_now();
  if (at_rest_quality > kAsWell_ratio * quality_) {
    quality_ = at_rest_quality;
  } else {
    snakes_.restore(outer, inner);
  }
}

std::optional<Eigen::Vector2d> CellFollower::notice_jump(const FrameInput& frame) {
  const PartTimer timer(frame.timings->rigid_us);
  return scene_.update(frame.image);
}

// Rigid motion of the whole: by the holder where there is one, else by the far side, once the contour is known.
void CellFollower::follow_rigid_motion(const FrameInput& frame, const Eigen::Vector2d& jump) {
  const PartTimer timer(frame.timings->rigid_us);
  if (rigid_.valid() && rigid_.track(frame.image, kRigidReach_px + jump.norm(), jump)) {
    motion_ = rigid_.motion();
    are_walls_seen_ = true;
  } else {
    motion_.shift += jump;
    are_walls_seen_ = false;
  }
}

// Without a holder, or where its walls are not found, the cell's seat gives the rigid motion. With one it is a check:
// the long walls of a pipette fit anywhere along themselves, and a cell may leave its holder; neither must look like an
// indentation.
void CellFollower::check_rigid_motion(const FrameInput& frame, const Eigen::Vector2d& center_before,
                                      const Eigen::Vector2d& jump) {
  const Eigen::Vector2d seat_before = seat_;
  seat_ = seat_center();
  if (!rigid_.valid()) return follow_seat();
  if (!are_walls_seen_) {
    follow_seat();
    rigid_.move_by(motion_.shift - rigid_.motion().shift);
  } else if (contact_.state() == CellState::kFree) {
    check_walls_by_outline(frame);
  } else {
    check_walls_by_seat(frame, seat_ - seat_before, center_now() - center_before, jump);
  }
}

// Nothing shows the place of an untouched cell as well as its outline. A holder that is elsewhere for some frames is
// the needle, if it comes from there; else it is learnt anew, and no longer followed where it parts from the cell
// again.
void CellFollower::check_walls_by_outline(const FrameInput& frame) {
  const double dent = kDent_ratio * std::max(0.0, needle_.valid() ? tip_depth() : 0.0);
  const double limit = kMoved_sigmas * std::hypot(is_read_ ? kReadSigma_px : kOutlineSigma_px, kWallsSigma_px, dent);
  const auto gap = [this] { return Eigen::Vector2d(seat_ - center_now()); };
  const bool astray = gap().norm() > std::max(kSlid_px, kSlid_ratio * rest_.outer_radius);
  astray_frames_ = astray ? astray_frames_ + 1 : 0;
  walls_slide_ = false;
  if (!may_be_pushed()) walls_slip_ += kSlipPace * (std::abs(gap().dot(holder_direction())) - walls_slip_);
  if (gap().norm() <= limit) return;
  if (rigid_.correct(frame.image, rigid_.motion().shift + gap())) motion_ = rigid_.motion();
  if (gap().norm() > limit) rigid_.move_by(gap());
  motion_ = rigid_.motion();
  if (astray_frames_ < kAstrayFrames || may_be_pushed()) return;
  astray_frames_ = 0;
  const bool is_needle = needle_.valid() && needle_.estimate().direction.dot(holder_direction()) < 0.0;
  if (!is_needle && ++times_astray_ > kMostAstray) return rigid_.reset();
  rest_.center = seat_;
  motion_ = {};
  motion_.pivot = rest_.center;
  if (is_needle) find_holder_anew(frame);
  learn_holder_motion(frame);
}

// From one frame to the next the seat moves with the holder, but for a share of the needle's own way; and where they
// part slowly, the walls have slid: the seat is followed along the holder.
void CellFollower::check_walls_by_seat(const FrameInput& frame, const Eigen::Vector2d& seat_way,
                                       const Eigen::Vector2d& holder_way, const Eigen::Vector2d& jump) {
  // What the needle pushed, it pushed by its way against the cell.
  const double push = needle_.valid() ? (needle_.motion() - seat_way).norm() : 0.0;
  if ((seat_way - holder_way).norm() > std::max(kLeastJump_px, kJump_ratio * rest_.outer_radius) + 0.5 * push) {
    if (!rigid_.correct(frame.image, rigid_.motion().shift + seat_way - holder_way)) {
      // One of the two has jumped, and the picture as a whole has not.
      if ((holder_way - jump).norm() <= (seat_way - jump).norm()) return;
      rigid_.move_by(seat_way - holder_way);
    }
    motion_ = rigid_.motion();
    return;
  }
  const double gap = (seat_ - center_now()).dot(holder_direction());
  const double least = std::max({kSlid_px, kSlid_ratio * rest_.outer_radius, kMoved_sigmas * seat_way_sigma()});
  const bool astray = std::abs(gap) > least && !has_drifted_here();
  astray_frames_ = astray ? astray_frames_ + 1 : 0;
  walls_slide_ = walls_slide_ || walls_slip_ > kSlips_px || astray_frames_ >= kAstrayFrames;
  if (!walls_slide_) return;
  // The walls tell across the pipette, seat and drift along it.
  rigid_.move_by((place_by_seat() - center_now()).dot(holder_direction()) * holder_direction());
  motion_ = rigid_.motion();
}

void CellFollower::follow_seat() {
  motion_.shift += place_by_seat() - center_now();
}

// The seat, by what is known of either weighed against where the drift before the touch has led: beside a needle that
// pushes deep the far side bulges. What is farther from there than that has moved.
Eigen::Vector2d CellFollower::place_by_seat() {
  const bool is_free = contact_.state() == CellState::kFree;
  const double depth = std::max(0.0, membrane_depth_);
  const double bulge = is_free ? kDent_ratio * depth : holder_ ? seat_way_sigma() : kBulge_ratio * depth;
  const Eigen::Vector2d gap = seat_ - drift_.place();
  const double seat = std::hypot(is_free ? kOutlineSigma_px : kSeatSigma_px, bulge), drift = drift_.sigma_px(),
               both = std::hypot(seat, drift);
  const bool has_moved = !may_be_pushed() || gap.norm() > kMoved_sigmas * both;
  seat_sigma_ = has_moved ? seat : seat * drift / both;
  return has_moved ? seat_ : drift_.place() + std::pow(drift / both, 2) * gap;
}

// By how much the holder lets its seat go by, px.
double CellFollower::seat_way() const {
  const double narrow = std::clamp(holder_->half_width / rest_.outer_radius, kNarrowest_ratio, 1.0);
  const double along = needle_.valid() ? std::max(0.0, needle_.estimate().direction.dot(holder_direction())) : 0.0;
  return kSeatWay_ratio * std::pow(narrow, kSeatWayPower) * along * std::max(0.0, membrane_depth_);
}

double CellFollower::seat_way_sigma() const {
  return std::hypot(kSeatWaySigma_ratio * seat_way(), kDepthSigma_ratio * std::max(0.0, membrane_depth_));
}

bool CellFollower::may_be_pushed() const {
  return contact_.state() != CellState::kFree || (needle_.valid() && tip_depth() >= -kAway_px);
}

// The walls put the cell where the drift before the touch has led.
bool CellFollower::has_drifted_here() const {
  return drift_.sigma_px() < kSlid_px && (center_now() - drift_.place()).norm() < kSlid_px;
}

bool CellFollower::follow(const FrameInput& frame) {
  ++frames_followed_;
  const std::optional<Eigen::Vector2d> jump = notice_jump(frame);
  const Eigen::Vector2d center_before = center_now();
  follow_rigid_motion(frame, jump.value_or(Eigen::Vector2d::Zero()));
  drift_.advance(jump ? Eigen::Vector2d(center_now() - center_before) : Eigen::Vector2d::Zero());
  if (frame.command) frame.command->move_scene(center_now() - center_before);
  // The holder's fit says better than the picture as a whole how far a jump went.
  follow_needle(frame, jump ? Eigen::Vector2d(center_now() - center_before) : Eigen::Vector2d::Zero());

  const bool punctured = contact_.state() == CellState::kPunctured;
  touching_ = needle_.valid() && !punctured && tip_depth() > 0.5;
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
                   needle_.valid() ? needle_.estimate().tip_sigma : 0.0, is_pushed()});
  if (was_free && contact_.state() == CellState::kContact && zone().is_shade) needle_.rest_on(apex(), apex_sigma());
  if (!may_be_pushed()) {
    drift_.learn(center_now());
    learn_rest(frame);
  }
  measure_dent();
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

// Centre of the resting circle through the part of the contour that what pushes the cell leaves where it is, radius
// fixed: all of it while nothing does; else where the holder seats it, less what that lets go by, or, without a holder,
// opposite the needle.
Eigen::Vector2d CellFollower::seat_center() const {
  const bool pushed = contact_.state() != CellState::kFree;
  const double least = !pushed ? -1.0 : holder_ ? kSeatCosine : kFarCosine;
  const Eigen::Vector2d seat = holder_           ? holder_direction()
                               : needle_.valid() ? needle_.estimate().direction
                                                 : Eigen::Vector2d::Zero();
  const Eigen::Matrix2Xd& points = snakes_.outer().points;
  Eigen::Vector2d center = center_now();
  for (int round = 0; round < kSeatRounds; ++round) {
    const double scale_px = std::max(kSeatScale_px, kSeatReach_px / (1.0 + round));
    Eigen::Matrix2d normal = 1e-6 * Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Eigen::Vector2d d = points.col(i) - center;
      const Eigen::Vector2d n = d.normalized();
      if (n.dot(seat) < least) continue;
      const double off = d.norm() - rest_.outer_at(n, motion_.angle_rad), share = off / scale_px;
      const double w = 1.0 / (1.0 + share * share);
      normal += w * n * n.transpose();
      right += w * off * n;
    }
    center += normal.inverse() * right;
  }
  return pushed && holder_ ? Eigen::Vector2d(center - seat_way() * seat) : center;
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
