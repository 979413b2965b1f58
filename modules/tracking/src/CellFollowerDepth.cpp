// How far tip and membrane are past the resting membrane, and how surely; how sure the whole frame is.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "CellFollower.h"
#include "Dent.h"

namespace pellucida {
namespace {

// The most confidence in what one way of seeing has shown: nothing independent confirms where the boundaries lie.
constexpr double kMostOfOneWay = 0.75;
// A tip less surely known (standard deviation) may well be 3 px off, which no frame that is sure should be.
constexpr double kVagueTip_px = 1.0;
// Nor one whose edges are as dark as this far beyond the glass (standard deviation, px): a fringe of the optics may lie
// 3 px before it. Set on validation film 55995 and plain ones (1.5 at most).
constexpr double kBroadEdge_px = 2.2;

// Flanks of a dimple: so far beside the needle's line through the centre, of the radius; shallower ones say nothing,
// px; how their depth of late fades, per frame; what share of it is back; what the tip must have kept of its depth
// meanwhile.
constexpr double kFlankFrom_ratio = 0.2, kFlankTo_ratio = 0.65;
constexpr double kLeastFlank_px = 2.0, kFlankFade = 0.95, kFlankBack_ratio = 0.6, kTipStays_ratio = 0.85;
// Flanks that deep, of what the needle's depth makes them, are pushed: a membrane that gave way takes back 0.15 of them
// in its first frame and more. A membrane that has come back to this share of its depth has jumped.
constexpr double kPushedFlank_ratio = 0.85, kCut_ratio = 0.8;
// Those say it from so many times on what they seem to move from frame to frame while nothing pushes them, at least
// from here on, px; the pace of that. Of 36 tuning films (306001 to 306040) they seemed to move by 0.04 px in the
// median film, by 0.15 px in one of ten, and lay no more than 0.1 and 0.4 px within the resting outline.
constexpr double kFlankNoises = 6.0, kLeastTelling_px = 0.5, kFlankPace = 0.2;
// The sides of a pushed cell, so far beside the needle's line through the centre, of the radius, bulge: by so much, px,
// they say whether it is; of what the needle's depth makes of their bulge, what is left of it while it is. On 120 wide
// films (179101 to 179260), of sides within 60 to 120 degrees of it, untouched cells showed less than 0.6 px in 99 % of
// the frames; in contact more than 0.75 of it was left in 99.5 %, in the first frame of a puncture 0.6 in the median,
// in the second 0.34.
constexpr int kLeastSidePoints = 12;
constexpr double kSide_ratio = 0.85, kLeastBulge_px = 1.0, kPushedBulge_ratio = 0.75;
// Sides that lie so far off their resting place while nothing touches the cell, px, as where the outline runs round
// cells that sit on the membrane, say nothing. Looked at on validation film 55289 (3.4 px, and 3.5 to 3.9 px in
// contact and after the puncture).
constexpr double kMostAtRest_px = 1.0;

// What a look at the picture beside the tip says so surely is so.
constexpr double kSeenSurely = 0.9;

// A new dent of a cell followed by lines without a needle in view: of the radius, and in what dents differ by from
// frame to frame; the pace of that. Film 80326, whose needle isn't found: 0.0003 from frame to frame, 0.025 3 um deep.
constexpr double kLeastDented_ratio = 0.03, kDentNoises = 12.0, kDentPace = 0.1;

// Standard deviations, px: of the resting outline along the needle, the membrane's uneven edge included; where it was
// not seen undisturbed.
constexpr double kRestSigma_px = 0.12, kUnknownSigma_px = 1.5;

}  // namespace

// How far the tip is past the resting membrane, px.
double CellFollower::tip_depth() const {
  const NeedleEstimate& n = needle_.estimate();
  return (n.tip - entry_point()).dot(n.direction);
}

// Where the needle's line meets the resting outline.
Eigen::Vector2d CellFollower::entry_point() const {
  const NeedleEstimate& n = needle_.estimate();
  return rest_.entry_point(center_now(), n.tip, n.direction, motion_.angle_rad);
}

double CellFollower::measure_membrane_depth() const {
  if (!needle_.valid()) return 0.0;
  return first_crossing(snakes_.outer().points, entry_point(), needle_.estimate().direction, 0.0);
}

void CellFollower::measure_dent() {
  const double before = dent_;
  dent_ = dent_ratio(snakes_.outer().points, center_now(), holder_ ? std::optional(holder_direction()) : std::nullopt);
  least_dent_ = std::min(least_dent_, dent_);
  if (!needle_.valid() && new_dent_ratio() < kLeastDented_ratio)
    dent_noise_ratio_ += kDentPace * (std::abs(dent_ - before) - dent_noise_ratio_);
}

// Where lines show no needle a dent is all there is to see of a push.
double CellFollower::least_new_dent_ratio() const noexcept {
  if (needle_.valid() || is_read_) return kDented_ratio;
  return std::clamp(kDentNoises * dent_noise_ratio_, kLeastDented_ratio, kDented_ratio);
}

// How deep the outline lies within the resting one on the side `toward` (unit), px: the mean over what is so far beside
// the line through the centre, of the radius.
double CellFollower::inward_px(const Eigen::Vector2d& toward, double from_ratio, double to_ratio) const {
  const Eigen::Matrix2Xd& points = snakes_.outer().points;
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d d = points.col(i) - center_now();
    const double across = std::abs(toward.x() * d.y() - toward.y() * d.x()) / rest_.outer_radius;
    if (d.dot(toward) < 0.0 || across < from_ratio || across > to_ratio) continue;
    sum += rest_.outer_at(d.normalized(), motion_.angle_rad) - d.norm();
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

// The dimple's flanks, beside what the needle hides or ties.
double CellFollower::flank_depth() const {
  return inward_px(-needle_.estimate().direction, kFlankFrom_ratio, kFlankTo_ratio);
}

double CellFollower::side_bulge() const {
  return resting_bulge_ < kMostAtRest_px ? sides_off_rest() : 0.0;
}

double CellFollower::sides_off_rest() const {
  const Eigen::Vector2d toward = needle_.estimate().direction;
  const Eigen::Matrix2Xd& points = snakes_.outer().points;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double squares = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d d = points.col(i) - center_now(), outward = d.normalized();
    if (std::abs(toward.x() * d.y() - toward.y() * d.x()) < kSide_ratio * rest_.outer_radius) continue;
    const double off = d.norm() - rest_.outer_at(outward, motion_.angle_rad);
    normal += outward * outward.transpose();
    right += off * outward;
    squares += off * off;
    ++count;
  }
  if (count < kLeastSidePoints) return 0.0;
  const Eigen::Vector2d shift = normal.ldlt().solve(right);
  return std::sqrt(std::max(0.0, squares - shift.dot(right)) / count);
}

void CellFollower::read_puncture(const FrameInput& frame) {
  pierced_probability_.reset();
  if (!needle_.valid() || !frame.networks || tip_depth() < PunctureNetwork::kLeastDepth_px) return;
  const NeedleEstimate& n = needle_.estimate();
  pierced_probability_ = frame.networks->punctures().read(frame.image, {n.tip, n.direction}, tip_depth(), center_now());
}

bool CellFollower::is_seen_through() const noexcept {
  return pierced_probability_ && *pierced_probability_ > kSeenSurely;
}

bool CellFollower::is_seen_pushed() const noexcept {
  return pierced_probability_ && *pierced_probability_ < 1.0 - kSeenSurely;
}

// Something pushes the cell, by its sides where a network reads them and they bulge enough to say, else by the dimple's
// flanks, which lines show from the first frame of a recoil on. Both go with the needle's depth squared.
bool CellFollower::is_shape_pushed() const {
  if (!needle_.valid()) return false;
  const double kept = std::clamp(tip_depth() / std::max(tip_at_largest_bulge_, 1.0), 0.0, 1.0);
  const double expected = kept * kept * largest_bulge_;
  return is_read_ && expected > kLeastBulge_px ? side_bulge() > kPushedBulge_ratio * expected : are_flanks_pushed();
}

// Something pushes the cell, wherever its contour is under the tip. Lines show a recoil sooner than the picture does.
bool CellFollower::is_pushed() const {
  if (!needle_.valid() || is_seen_through()) return false;
  return (is_read_ && is_seen_pushed()) || is_shape_pushed();
}

void CellFollower::follow_bulge() {
  if (is_pushed() && contact_.state() != CellState::kPunctured) largest_bulge_ *= kFlankFade;
  const double bulge = side_bulge();
  if (bulge < largest_bulge_) return;
  largest_bulge_ = bulge;
  tip_at_largest_bulge_ = tip_depth();
}

void CellFollower::learn_flank_noise() {
  if (!needle_.valid()) return;
  const double flank = flank_depth();
  flank_noise_ += kFlankPace * (std::abs(flank - flank_before_) - flank_noise_);
  flank_before_ = flank;
  resting_bulge_ += kFlankPace * (sides_off_rest() - resting_bulge_);
}

void CellFollower::follow_flanks() {
  if (contact_.state() == CellState::kFree || !needle_.valid()) {
    deepest_flank_ = largest_bulge_ = 0.0;
    learn_flank_noise();
    return;
  }
  follow_bulge();
  const double flank = flank_depth();
  if (!are_flanks_back() && contact_.state() != CellState::kPunctured) deepest_flank_ *= kFlankFade;
  if (flank < deepest_flank_) return;
  deepest_flank_ = flank;
  tip_at_deepest_flank_ = tip_depth();
}

// The flanks of the dimple are where they were of late.
bool CellFollower::has_deep_flanks() const {
  return deepest_flank_ > kLeastFlank_px && flank_depth() >= kFlankBack_ratio * deepest_flank_;
}

// They have come back and the tip, which pushed them, has not.
bool CellFollower::are_flanks_back() const {
  return needle_.valid() && deepest_flank_ > kLeastFlank_px && !has_deep_flanks() &&
         tip_depth() > kTipStays_ratio * tip_at_deepest_flank_;
}

// They are as deep as they were of late, but for what the needle's own way back explains: they go with its depth
// squared.
bool CellFollower::are_flanks_pushed() const {
  if (!needle_.valid() || deepest_flank_ <= 0.0) return false;
  const double kept = std::clamp(tip_depth() / std::max(tip_at_deepest_flank_, 1.0), 0.0, 1.0);
  const double flank = flank_depth();
  // What a puncture leaves of a dimple is no push.
  const double least_px = contact_.state() == CellState::kPunctured
                              ? kLeastFlank_px
                              : std::clamp(kFlankNoises * flank_noise_, kLeastTelling_px, kLeastFlank_px);
  return flank > least_px && flank >= kPushedFlank_ratio * kept * kept * deepest_flank_;
}

// A contour that goes back under the tip alone is no membrane that gives way: it cuts across a narrow dimple.
bool CellFollower::cuts_dimple() const {
  return measure_membrane_depth() < kCut_ratio * membrane_depth_ && is_pushed();
}

double CellFollower::membrane_sigma() const {
  if (!needle_.valid()) return 0.0;
  // The few points beside the axis share what the rigidity ties together: their mean sigma represents all.
  const NeedleEstimate& n = needle_.estimate();
  const SnakeContour& outer = snakes_.outer();
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < outer.points.cols(); ++i) {
    const Eigen::Vector2d d = outer.points.col(i) - n.tip;
    const double across = std::abs(n.direction.x() * d.y() - n.direction.y() * d.x());
    if (across > n.tip_half_width + 4.0 || (outer.points.col(i) - center_now()).dot(n.direction) > 0.0) continue;
    sum += outer.sigma_px[i];
    ++count;
  }
  return count > 0 ? sum / count : kUnknownSigma_px;
}

double CellFollower::rest_sigma() const {
  return std::hypot(rest_.seen_free ? kRestSigma_px : kUnknownSigma_px, place_sigma_);
}

double CellFollower::depth_sigma() const {
  // Where the membrane under the needle is hidden, the tip that it wraps gives its depth.
  const double tip =
      needle_.valid() && needle_.estimate().tip_sigma > 0.0 ? needle_.estimate().tip_sigma : kUnknownSigma_px;
  return std::hypot(std::min(membrane_sigma(), tip), rest_sigma());
}

// How well the tip's way past the resting membrane is known; 0: not at all.
double CellFollower::past_sigma() const {
  const NeedleEstimate& n = needle_.estimate();
  const bool is_known = needle_.valid() && needle_.is_clear() && !n.is_disputed && rest_.seen_free;
  return is_known ? std::hypot(n.tip_sigma, rest_sigma()) : 0.0;
}

double CellFollower::confidence() const {
  const NeedleEstimate& n = needle_.estimate();
  const bool is_tip_vague = needle_.valid() && (needle_.is_read() || n.is_disputed || n.tip_sigma > kVagueTip_px ||
                                                n.edge_blur > kBroadEdge_px);
  return is_tip_vague ? std::min(kMostOfOneWay, membranes_confidence()) : membranes_confidence();
}

double CellFollower::membranes_confidence() const {
  const double sides = std::min(snakes_.outer().score, 0.3 + 0.7 * local_score());
  const double sudden = usual_quality_ > 0.0 ? std::clamp(quality_ / usual_quality_, 0.0, 1.0) : 1.0;
  const double first_sight = rest_.seen_free ? 1.0 : 0.7;
  const bool is_needle_poor = needle_.valid() && needle_.estimate().confidence < kPoorNeedle;
  const double most = is_read_ || is_doubtful_ || is_needle_poor ? kMostOfOneWay : 1.0;
  const double all = std::clamp(sides * sudden * sudden * first_sight * detection_score_, 0.0, most);
  return bad_frames_ > 0 ? 0.3 * all : all;
}

}  // namespace pellucida
