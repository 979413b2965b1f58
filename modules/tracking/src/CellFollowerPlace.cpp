// Where the cell is: by its holding pipette's walls, which its own outline and seat check; without them by its seat and
// the drift before the touch.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "CellFollower.h"

namespace pellucida {
namespace {

// A tip that far outside the resting outline touches nothing.
constexpr double kAway_px = 2.0;
// How far the holder may move between two frames, the search for it included.
constexpr double kRigidReach_px = 38.0;
// The seat so far (of the radius, and px) from where the holder puts it, within a frame: one of the two has jumped; or
// so far, px and of the radius, for so many frames. On 25 films with a holder (validation 22001 to 22040) the seat was
// within 1.7 px of the truth, the walls within 2.5 px in 24 and 12 px off in one.
constexpr double kJump_ratio = 0.03, kLeastJump_px = 1.5;
constexpr double kSlid_px = 2.0, kSlid_ratio = 0.03;
constexpr int kAstrayFrames = 3, kMostAstray = 1;
// Walls that are so far from an untouched cell's place along the pipette, px, in the mean of late, don't tell where it
// is; how that mean follows, per frame.
constexpr double kSlips_px = 0.5, kSlipPace = 0.3;
// Within so much (cosine) of the holder's direction the membrane stays on its mouth; where no holder is known, more of
// it has to do. Rounds of the fit, at most, and the step that ends them; its scale at first and last.
constexpr double kSeatCosine = 0.85, kFarCosine = 0.5;
constexpr int kSeatRounds = 12;
constexpr double kSeatSettled_px = 1e-5;
constexpr double kSeatReach_px = 8.0, kSeatScale_px = 2.0;
// Standard deviations of the seat where no holder's walls show the motion: px, by the whole outline and in contact, and
// of the needle's depth, which dents the one and, without a holder in view, bulges the far side of the other; how far
// from its drift a cell has moved. Without: a holder beside the needle's line lets the far side go by 0.41 of a push of
// 25 um (wide film 179137).
constexpr double kOutlineSigma_px = 0.1, kSeatSigma_px = 0.45;
constexpr double kDent_ratio = 0.2, kBulge_ratio = 0.4, kMoved_sigmas = 3.0;
// A holder lets its seat go by towards it, by this share of the needle's depth times a power of its radius over the
// cell's; how much that differs, over itself, and of the depth. By the outlines of 755 specimens (3101 to 3934) pushed
// by 0.15 R and more: 0.07 of the depth at 0.17 R, 0.034 at 0.22, 0.011 at 0.35; below 0.4 R 90 % of them are within
// 0.6 to 1.5 of that.
constexpr double kSeatWay_ratio = 0.0013, kSeatWayPower = -2.2, kNarrowest_ratio = 0.12;
constexpr double kSeatWaySigma_ratio = 0.4, kDepthSigma_ratio = 0.01;
// So far about its line, of the radius, what was taken for the holder presses the cell where nothing else is seen to:
// by so much, of the radius, for so many frames. Untouched cells are within 0.2 px of it (validation 83093).
constexpr double kPressedAbout_ratio = 0.3, kPressed_ratio = 0.05;
constexpr int kPressedFrames = 2;
// Of the outline of a cell that networks read; of where the walls put it, and from how many of the outline's on they
// slide. As recorded and weighed so, cells of 106 tuning, wide and plain films (303001 to 303040, 307001 to 307040,
// 88061 to 88129) are 0.09, 0.22 and 0.07 px from their place in the median and 0.4, 0.6 and 0.24 in nine of ten, by
// the walls alone 0.08, 0.27 and 0.07, and 0.55, 1.07 and 0.26.
constexpr double kReadSigma_px = 0.25, kWallsSigma_px = 0.1, kSlid_sigmas = 2.0;

}  // namespace

std::optional<Eigen::Vector2d> CellFollower::notice_jump(const FrameInput& frame) {
  const PartTimer timer(frame.timings->rigid_us);
  return scene_.update(frame.image);
}

// Rigid motion of the whole: by the holder where there is one, else by the far side, once the contour is known.
void CellFollower::follow_rigid_motion(const FrameInput& frame, const Eigen::Vector2d& jump) {
  const PartTimer timer(frame.timings->rigid_us);
  if (rigid_.valid() && rigid_.track(frame.image, kRigidReach_px + jump.norm(), jump)) {
    motion_ = rigid_.motion();
    motion_.shift += beside_walls_;
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
    beside_walls_.setZero();
    return;
  }
  const Eigen::Vector2d way = center_now() - center_before;
  motion_ = rigid_.motion();
  beside_walls_.setZero();
  if (contact_.state() == CellState::kFree) {
    check_walls_by_outline(frame);
  } else {
    check_walls_by_seat(frame, seat_ - seat_before, way, jump);
  }
  if (rigid_.valid() && !walls_slide_) weigh_walls();
}

// Walls, and the outline: of an untouched cell all of it, of a pushed one what the holder seats, which says where the
// cell is along the pipette. Each by how well it is seen.
void CellFollower::weigh_walls() {
  const bool is_free = contact_.state() == CellState::kFree;
  Eigen::Vector2d gap = seat_ - center_now();
  if (!is_free) gap = gap.dot(holder_direction()) * holder_direction();
  const double seat = is_free ? outline_sigma() : std::hypot(kSeatSigma_px, seat_way_sigma());
  // Farther from the outline than that can be wrong, the walls slide along themselves; but not where the drift before
  // the touch has led nearer to them than to the seat.
  const bool are_walls_due = !is_free && is_drift_nearer_to_walls();
  const double slid_px2 = are_walls_due ? 0.0 : gap.squaredNorm() - std::pow(kSlid_sigmas * seat, 2);
  walls_slid_px2_ += kSlipPace * (std::max(0.0, slid_px2) - walls_slid_px2_);
  const double walls =
      std::sqrt(std::pow(std::hypot(kWallsSigma_px, rigid_.sigma_px(holder_direction())), 2) + walls_slid_px2_);
  const double both = std::hypot(walls, seat);
  beside_walls_ = std::pow(walls / both, 2) * gap;
  motion_.shift += beside_walls_;
  place_sigma_ = walls * seat / both;
}

// Of an untouched cell's place by its outline, which a needle may begin to dent, px.
double CellFollower::outline_sigma() const {
  const double dent = kDent_ratio * std::max(0.0, needle_.valid() ? tip_depth() : 0.0);
  return std::hypot(is_read_ ? kReadSigma_px : kOutlineSigma_px, dent);
}

// Nothing shows the place of an untouched cell as well as its outline. A holder that is elsewhere for some frames is
// the needle, if it comes from there; else it is learnt anew, and no longer followed where it parts from the cell
// again.
void CellFollower::check_walls_by_outline(const FrameInput& frame) {
  const double limit = kMoved_sigmas * std::hypot(outline_sigma(), kWallsSigma_px);
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

// A holder presses nothing: where no needle is seen and it does, it is the needle, and what faces it the holder.
void CellFollower::check_holder_by_outline(const FrameInput& frame) {
  if (needle_.valid() || !holder_ || !rest_.seen_free) {
    unpressed_.reset();
    pressed_frames_ = 0;
    return;
  }
  const double pressed_px = inward_px(holder_direction(), 0.0, kPressedAbout_ratio),
               least_px = kPressed_ratio * rest_.outer_radius;
  if (!unpressed_ || pressed_px < 0.5 * least_px) {
    unpressed_ = rest_;
    unpressed_->center = center_now();
    unpressed_->shape = rest_.shape.turned_back(-motion_.angle_rad);
  }
  pressed_frames_ = pressed_px > least_px ? pressed_frames_ + 1 : 0;
  if (pressed_frames_ < kPressedFrames || !take_holder_for_needle(frame)) return;
  rest_ = *unpressed_;
  motion_ = {};
  motion_.pivot = rest_.center;
  drift_.reset();
  walls_slide_ = false;
  learn_holder_motion(frame);
}

// From one frame to the next the seat moves with the holder, but for a share of the needle's own way; and where they
// part slowly, the walls have slid: the seat is followed along the holder.
void CellFollower::check_walls_by_seat(const FrameInput& frame, const Eigen::Vector2d& seat_way,
                                       const Eigen::Vector2d& holder_way, const Eigen::Vector2d& jump) {
  // What the needle pushed, it pushed by its way against the cell.
  const double push = needle_.valid() ? (tip_way() - seat_way).norm() : 0.0;
  if ((seat_way - holder_way).norm() > std::max(kLeastJump_px, kJump_ratio * rest_.outer_radius) + 0.5 * push) {
    // One of the two has jumped, and the picture as a whole has not.
    if (!rigid_.correct(frame.image, rigid_.motion().shift + seat_way - holder_way) &&
        (holder_way - jump).norm() > (seat_way - jump).norm())
      rigid_.move_by(seat_way - holder_way);
    motion_ = rigid_.motion();
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
  place_sigma_ = has_moved ? seat : seat * drift / both;
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

// Along the holder, which walls say nothing of.
bool CellFollower::is_drift_nearer_to_walls() const {
  const auto off_px = [this](const Eigen::Vector2d& place) {
    return std::abs((drift_.place() - place).dot(holder_direction()));
  };
  return drift_.sigma_px() < kSlid_px && off_px(center_now()) < off_px(seat_);
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
    const Eigen::Vector2d way = normal.inverse() * right;
    center += way;
    if (scale_px == kSeatScale_px && way.norm() < kSeatSettled_px) break;
  }
  return pushed && holder_ ? Eigen::Vector2d(center - seat_way() * seat) : center;
}

}  // namespace pellucida
