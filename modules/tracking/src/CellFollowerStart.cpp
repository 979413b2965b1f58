// A cell that was found: whether it is one, and its shape at rest as far as one frame shows it.
#include <algorithm>

#include "CellFollower.h"
#include "ContourMath.h"
#include "OutlineShape.h"

namespace pellucida {
namespace {

// Tip past the resting membrane at first sight: it has entered the outline; it is deep enough to tell a dimple from
// none.
constexpr double kEntered_px = 2.4, kDeep_px = 9.6;
// A start poorer than this needs the shape of a cell: the red cell in a pipette's mouth has more, the ends of pipettes
// of films 27025 and 28025 less.
constexpr double kPoorStart = 0.25;
// px: by how much a dimple's flanks seem to move by themselves, as long as nothing was seen of it.
constexpr double kUnknownFlankNoise_px = 0.35;
// How probable a cell is by the network that judges what is found: less, and it is none. Of pictures held out from its
// training 99.9 % of the cells had more than 0.15, and 1 % of other things; a real red cell in a pipette's mouth, which
// kept the limit from being higher, has 0.17. From `kSureCell` on it is one, and boundaries read with the lower score
// will do.
constexpr double kLeastCell = 0.15, kSureCell = 0.9, kLeastOfSureCell = 0.63;
// Enough where everything else says that it is one: the scene's map and the boundaries are as sure as this, and a tool
// is at it. Validation film 54884, dark in phase contrast beside another cell, has 0.13, its map 0.98 and its
// boundaries 0.98.
constexpr double kLeastSeenCell = 0.08, kSureScene = 0.9;
// Of the radius expected of the kind: what is smaller or larger is another thing, as bubbles are. No force is known
// outside 0.6 to 1.7 of it.
constexpr double kSmallest_ratio = 0.4, kLargest_ratio = 2.5;
// A cell found anew within so much of the radius of where one was followed, and so much as large at least and at most,
// is that one: what a needle dents, or where another boundary is read, moves the circle through it by less.
constexpr double kSamePlace_ratio = 0.3, kSameSize_ratio = 0.8;

// Of an outline, on its circle at most, and, px and of the radius, off the oval at most (RMS), for a cell that is one.
// Looked at on validation films 54950 and 55622.
constexpr double kFewOnCircle = 0.6, kOvalMisfit_px = 0.8, kOvalMisfit_ratio = 0.01;

}  // namespace

// What was found, by the network that has seen cells and other things; a bubble's rim is as clear as a membrane.
bool CellFollower::is_cell(const FrameInput& frame, const contour::Circle& circle, double scene_share) const {
  const double share = frame.networks->cells().read(frame.image, circle.center, circle.radius);
  const bool is_poor = is_read_ && snakes_.outer().score < frame.least_score;
  const bool is_seen = is_read_ && frame.scene != nullptr &&
                       std::min(scene_share, snakes_.outer().score) > kSureScene &&
                       is_worked_on(*frame.scene, circle.center, circle.radius);
  return share >= (is_poor ? kSureCell : is_seen ? kLeastSeenCell : kLeastCell);
}

bool CellFollower::is_sized(const FrameInput& frame, const contour::Circle& circle) const {
  const double ratio = circle.radius * frame.view.pixel_size_um / options_.expected_radius_um;
  return frame.is_vouched || !(options_.expected_radius_um > 0.0) ||
         (ratio > kSmallest_ratio && ratio < kLargest_ratio);
}

// None of the kind, whatever it is; that it looks like one is said.
bool CellFollower::refuse(const FrameInput& frame, const contour::Circle& circle) {
  if (frame.refused_radius_px && frame.networks &&
      frame.networks->cells().read(frame.image, circle.center, circle.radius) >= kSureCell)
    *frame.refused_radius_px = circle.radius;
  return false;
}

bool CellFollower::start(const FrameInput& frame, const DetectedCell& cell) {
  if (!is_sized(frame, cell.circle)) return refuse(frame, cell.circle);
  touching_ = false;
  forget_needle();
  find_tools_of(frame, cell.circle);
  const NeedleZone needle_zone = zone();
  const NeedleZone* known = needle_.valid() ? &needle_zone : nullptr;
  is_read_ = frame.reader != nullptr;
  is_doubtful_ = is_needle_doubtful_ = false;
  const bool is_judged = frame.networks != nullptr && !frame.is_vouched;
  if (is_read_) {
    const double least = is_judged ? std::min(frame.least_score, kLeastOfSureCell) : frame.least_score;
    if (!snakes_.start(frame.image, frame.reader->boundaries(), cell.outer.points, cell.score, known, least))
      return false;
  } else if (!snakes_.start(frame.image, cell.lines(), frame.noise, known)) {
    return false;
  }
  zona_.start(frame.image, frame.noise, cell, snakes_.outer());
  detection_score_ = std::min(1.0, snakes_.sureness() / 0.6);
  bad_frames_ = poor_frames_ = frames_followed_ = 0;

  // The rest shape as far as this one frame shows it: the circle through the undeformed part.
  const contour::Circle circle = circle_of(snakes_.outer().points);
  const OutlineShape shape(snakes_.outer().points, circle);
  detection_score_ *= shape.roundness();
  const bool is_pushed = needle_.valid() && (needle_.estimate().tip - circle.center).norm() < circle.radius;
  if (!is_pushed && !shape.may_be_cell() && detection_score_ < kPoorStart) return false;
  if (is_judged && !is_cell(frame, circle, cell.score)) return false;
  if (!is_sized(frame, circle)) return refuse(frame, circle);
  rest_ = {};
  rest_at_first_sight(circle);
  rest_.inner_radius = snakes_.has_inner() ? circle_of(snakes_.inner().points).radius : 0.0;
  rest_.outer_sigma_px = outer_sigma();
  // Membranes that are not one inside the other are none.
  if (rest_.inner_radius >= rest_.outer_radius) return false;
  motion_ = {};
  motion_.pivot = rest_.center;
  walls_slide_ = false;
  scene_.reset();
  scene_.update(frame.image);
  astray_frames_ = times_astray_ = 0;
  walls_slip_ = 0.0;
  seat_ = rest_.center;
  learn_holder_motion(frame);
  if (is_read_ && needle_.valid() && tip_depth() > kEntered_px) read_dimples(frame);
  membrane_depth_ = measure_membrane_depth();
  // Where a mere shade ends is not known well enough to say that it has entered an untouched outline.
  const bool certain = !zone().is_shade || membrane_depth_ > 0.5 * kEntered_px;
  const bool entered = needle_.valid() && tip_depth() > kEntered_px && certain;
  const bool through = entered && tip_depth() > kDeep_px && membrane_depth_ < 0.5 * tip_depth();
  contact_.reset(!entered ? CellState::kFree : through ? CellState::kPunctured : CellState::kContact);
  touching_ = entered && !through;
  drift_.reset();
  if (entered)
    read_thickness(frame);
  else
    learn_rest(frame);
  quality_ = usual_quality_ = first_quality_ = quality_now();
  measure_dent();
  least_dent_ = dent_;
  forget_depths();
  flank_noise_ = kUnknownFlankNoise_px;
  resting_bulge_ = 0.0;
  return true;
}

// An outline that most of lies off its circle, and that runs all round as an oval does, is that of a cell at rest,
// however far a needle at its flat side seems to be past the circle.
void CellFollower::rest_at_first_sight(const contour::Circle& circle) {
  rest_.center = circle.center;
  rest_.outer_radius = circle.radius;
  const OutOfRound::Fit oval = OutOfRound::fit(snakes_.outer().points, circle);
  const bool is_clear = !needle_.valid() || (needle_.estimate().tip - circle.center).norm() > circle.radius;
  const bool is_oval = circle.inlier_ratio < kFewOnCircle &&
                       oval.misfit_px < std::max(kOvalMisfit_px, kOvalMisfit_ratio * circle.radius);
  if (!is_clear && !is_oval) return;
  rest_.center = oval.circle.center;
  rest_.outer_radius = oval.circle.radius;
  rest_.shape = oval.shape;
}

// The cell at rest lies there in this frame: its motion counts from here on.
void CellFollower::rest_now_at(const Eigen::Vector2d& center) {
  rest_.center = center;
  rest_.shape = rest_.shape.turned_back(-motion_.angle_rad);
  motion_ = {};
  motion_.pivot = rest_.center;
}

void CellFollower::forget_depths() {
  deepest_flank_ = largest_bulge_ = 0.0;
}

CellFollower::Memory CellFollower::memory(const RigidMove& motion) const {
  Memory memory{rest_, contact_};
  memory.rest.center = motion.apply(rest_.center);
  memory.rest.shape = rest_.shape.turned_back(-motion.angle_rad);
  return memory;
}

void CellFollower::resume(const FrameInput& frame, const Memory& before) {
  const double radius = before.rest.outer_radius, ratio = rest_.outer_radius / radius;
  const bool is_same = (rest_.center - before.rest.center).norm() < kSamePlace_ratio * radius &&
                       ratio > kSameSize_ratio && ratio < 1.0 / kSameSize_ratio;
  if (before.contact.state() == CellState::kFree || !before.rest.seen_free || !is_same) return;
  rest_ = before.rest;
  motion_ = {};
  motion_.pivot = seat_ = rest_.center;
  contact_ = before.contact;
  touching_ = contact_.state() == CellState::kContact;
  learn_holder_motion(frame);
  if (is_read_ && needle_.valid() && tip_depth() > kEntered_px) read_dimples(frame);
  membrane_depth_ = measure_membrane_depth();
}

}  // namespace pellucida
