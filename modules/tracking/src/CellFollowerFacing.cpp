// Which of two tools that face each other at the cell is its needle.
#include "FacingTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "CellFollower.h"
#include "SceneVerdict.h"

namespace pellucida {
namespace {

// Of another's radius: the tip of a tool that faces it is finer. Set on first sights of wide and tuning pictures with
// specimens (700001 to 703999): of 30 with the wrong tool it gives the right one in 15.
constexpr double kFiner_ratio = 0.5;
// Of the cell's radius: a tool that ends so near to the outline touches it, one farther away does not; of a holding
// pipette's radius, that of a needle that faces it.
constexpr double kTouches_ratio = 0.08, kAway_ratio = 0.1, kNoWider_ratio = 1.2;
// Of the holder's half width: a tool half as wide as this that runs so near to its middle is one of its walls (wide
// 700138, 708381, 711183).
constexpr double kWallOfHolder_ratio = 0.4, kBesideHolder = 1.5;
// Frames between two looks at the tool that faces the needle.
constexpr int kWatch_frames = 3;

}  // namespace

bool is_before(const NeedleEstimate& needle, const Eigen::Vector2d& center, double most_px) {
  return (needle.tip - center).dot(needle.direction) < most_px;
}

bool is_along(const HolderFit& holder, const NeedleEstimate& needle, const Eigen::Vector2d& center,
              double half_widths) {
  const Eigen::Vector2d across(-holder.direction.y(), holder.direction.x());
  return -holder.direction.dot(needle.direction) > kAlongHolder &&
         std::abs((needle.tip - center).dot(across) - holder.offset) < half_widths * holder.half_width;
}

// Lines may have one wall alone for the holder, and the scene none: either may know better.
bool CellFollower::is_wall_of_holder(const NeedleEstimate& lines, const SceneReading& scene,
                                     const Eigen::Vector2d& center) const {
  if (holder_ && is_along(*holder_, lines, center, kBesideHolder) &&
      lines.tip_half_width < kWallOfHolder_ratio * holder_->half_width)
    return true;
  return std::any_of(scene.holders.begin(), scene.holders.end(), [&](const SceneTool& holder) {
    return lines.direction.dot(holder.direction) > kAlongHolder && is_one_wall(lines, holder);
  });
}

// Of two tools that face each other at the cell, whatever the scene takes a narrow holding pipette for: the one that
// touches an untouched cell holds it, and the one that is still away from it is the needle; else the one with the finer
// tip is.
void CellFollower::settle_facing(const FrameInput& frame, const contour::Circle& circle,
                                 const std::vector<FoundTool>& tools) {
  if (!needle_.valid()) return;
  needle_.read_width(frame.networks->tip_widths(), frame.image);
  const auto away_ratio = [&](const NeedleEstimate& n) { return (n.tip - circle.center).norm() / circle.radius - 1.0; };
  const auto is_needle = [&](NeedleTracker& other) {
    if (is_wall_of_holder(other.estimate(), *frame.scene, circle.center)) return false;
    other.read_width(frame.networks->tip_widths(), frame.image);
    const NeedleEstimate &n = other.estimate(), &now = needle_.estimate();
    if (!is_before(n, circle.center, kThrough_ratio * circle.radius)) return false;
    const double width_ratio = n.tip_radius / now.tip_radius, other_away = away_ratio(n), now_away = away_ratio(now);
    if (now_away > kAway_ratio && std::abs(other_away) < kTouches_ratio) return false;
    const bool now_holds = std::abs(now_away) < kTouches_ratio && other_away > kAway_ratio;
    return width_ratio < (now_holds ? kNoWider_ratio : kFiner_ratio);
  };
  const Eigen::Vector2d direction = needle_.estimate().direction;
  for (const FoundTool& tool : tools) {
    if (tool.direction.dot(direction) < kAlongHolder) continue;
    NeedleTracker other;
    if (!other.start(frame.image, tool, frame.noise) ||
        !other.find_tip(frame.networks->tips(), frame.image, circle.center) || !is_needle(other))
      continue;
    needle_ = std::move(other);
    return;
  }
  for (const SceneTool& seen : frame.scene->needles) {
    if (-seen.direction.dot(direction) < kAlongHolder) continue;
    NeedleTracker other;
    if (!start_by_scene(other, frame, seen, circle.center) || !is_needle(other)) continue;
    needle_ = std::move(other);
    return;
  }
}

// A needle of the scene whose shaft can't be followed.
bool CellFollower::start_by_tip(NeedleTracker& needle, const FrameInput& frame, const SceneTool& seen,
                                const Eigen::Vector2d& center) {
  TipNetwork& tips = frame.networks->tips();
  NeedleAxis axis{seen.tip, seen.direction};
  axis.tip = tips.find(frame.image, axis, seen.half_width_px, center).tip;
  return needle.start_read(tips, frame.image, axis, seen.half_width_px);
}

// By its lines, or by its tip alone.
bool CellFollower::start_by_scene(NeedleTracker& needle, const FrameInput& frame, const SceneTool& seen,
                                  const Eigen::Vector2d& center) {
  const ExpectedTip expected = expected_tip(seen);
  if (needle.start(frame.image, found_tool(seen), frame.noise, &expected)) {
    needle.expect_half_width(seen.half_width_px);
    if (needle.find_tip(frame.networks->tips(), frame.image, center)) return true;
  }
  return start_by_tip(needle, frame, seen, center);
}

// What the motion of the two decides is left to it: what faces the needle is watched beside it.
void CellFollower::begin_watch(const FrameInput& frame, const contour::Circle& circle) {
  rival_.reset();
  if (!needle_.valid() || frame.networks == nullptr) return;
  const Eigen::Vector2d direction = needle_.estimate().direction;
  NeedleTracker other;
  const auto faces = [&](const SceneTool& seen) {
    return -seen.direction.dot(direction) > kAlongHolder && start_by_scene(other, frame, seen, circle.center);
  };
  bool is_seen = false;
  if (holder_ && direction.dot(holder_->direction) > kAlongHolder) {
    is_seen = other.start_read(frame.networks->tips(), frame.image, {holder_->mouth, -holder_->direction},
                               holder_->half_width);
  } else if (frame.scene) {
    is_seen = std::any_of(frame.scene->needles.begin(), frame.scene->needles.end(), faces);
  }
  if (is_seen) rival_.begin(std::move(other), needle_.estimate(), circle);
}

// The tool that faces the needle is the needle, where it goes into the cell and that rests.
void CellFollower::watch_facing(const FrameInput& frame) {
  if (!rival_.is_watched()) return;
  if (!needle_.valid() || frame.networks == nullptr) return rival_.reset();
  if (frames_followed_ % kWatch_frames != 0) return;
  const contour::Circle circle = circle_of(snakes_.outer().points);
  const RivalTool::Verdict verdict = rival_.watch(frame.networks->tips(), frame.image, needle_.estimate(), circle);
  if (verdict == RivalTool::Verdict::kIsHolder) rival_.reset();
  if (verdict != RivalTool::Verdict::kIsNeedle) return;
  needle_ = rival_.tool();
  needle_way_.reset();
  rival_.reset();
  contact_.reset(CellState::kContact);
  rest_now_at(circle.center);
  find_holder_anew(frame);
  // What it pushes may have gone into that circle; not what the holder seats.
  rest_.center = motion_.pivot = seat_ = seat_center();
  // As at a first sight in contact, and learnt anew once nothing touches the cell.
  rest_.seen_free = false;
  rest_.frame_count = 0;
  learn_holder_motion(frame);
  drift_.reset();
  walls_slide_ = false;
  forget_depths();
  begin_command(frame);
  read_tip_width(frame, false);
}

}  // namespace pellucida
