// The tools beside the followed cell: needle and holding pipette found, the needle followed.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "CellFollower.h"
#include "ContourMath.h"
#include "FacingTools.h"
#include "HintedHolder.h"
#include "HintedNeedle.h"
#include "SceneVerdict.h"

namespace pellucida {
namespace {

// Of the cell's radius: a tool is no needle when its half width is more, blur included; nor when its tip's is.
constexpr double kBroadTool_ratio = 0.3, kBroadTip_ratio = 0.15, kFacingTip_ratio = 0.25;
// An edge that many times as blurred as the membrane's line is wide can't be taken for one.
constexpr double kShade_ratio = 2.0;
// Standard deviation of the way from the membrane's apex, seen through a blurred needle, to the tip, px.
constexpr double kApexSigma_px = 0.15;
// How far a membrane's halo reaches, in widths of its line.
constexpr double kHaloLines = 4.0;
// The tip is in the clear that far from the resting outline, and further by so many blurs beyond a sharp needle's.
constexpr double kClear_px = 6.0, kClearBlurs = 3.0, kSharp_px = 1.5;
// Before the resting outline by so much, the tip touches nothing; so far behind tip or outline, the shaft is in view.
constexpr double kUntouched_px = 1.0, kBeyondCell_px = 6.0;

// A holder of the scene is as wide as the one found by lines when their logarithms are as near; one of its walls alone,
// when they are so far apart.
constexpr double kSameHolderWidth = 0.25, kOneWall = -0.6;
// Edges more even than this are the holder's (docs/method.md, 1.3).
constexpr double kEvenHolder = 0.4;
// Of the cell's radius: half the width of the narrowest pipette that holds it.
constexpr double kNarrowestFacing_ratio = 0.12;
// An end found by lines that moves so differently from the frame before is read by the network too.
constexpr double kCheckedLeap_px = 3.0;
// A needle that was lost comes back as it was, for so many frames: cosine of how far its direction may differ.
constexpr double kSameWay = 0.85;
constexpr int kRemembered_frames = 150;
// Frames between two readings of the tip's width, and which one of them: not one in which the contours' look is learnt.
constexpr int kWidth_frames = 8, kWidthFrame = 6;

// The whole image in floating point: for searches, not for following.
GrayImage gray(const ImageView& view) {
  GrayImage whole;
  load(view, whole);
  return whole;
}

// The tools that the scene shows as holding pipettes; without any, those that it doesn't show as needles.
std::vector<FoundTool> holders_among(const std::vector<FoundTool>& tools, const SceneReading& scene, bool by_lines) {
  std::vector<FoundTool> holders;
  const auto keep = [&](const auto& is_kept) {
    std::copy_if(tools.begin(), tools.end(), std::back_inserter(holders), is_kept);
  };
  for (const SceneTool& seen : scene.holders) {
    const std::size_t before = holders.size();
    keep([&](const FoundTool& tool) { return is_same(tool, seen); });
    if (holders.size() == before && (!by_lines || seen.is_short)) holders.push_back(found_tool(seen));
  }
  if (holders.empty() && by_lines)
    keep([&](const FoundTool& tool) {
      return std::none_of(scene.needles.begin(), scene.needles.end(),
                          [&](const SceneTool& seen) { return is_same(tool, seen); });
    });
  return holders;
}

// Uneven edges may be those of a halo: where the scene shows a holder of quite another width, that is its width.
void check_width(HolderFit& holder, const SceneReading& scene, bool by_lines) {
  if (holder.unevenness < kEvenHolder) return;
  for (const SceneTool& seen : scene.holders) {
    if (-holder.direction.dot(seen.direction) < kAlongHolder || !(seen.half_width_px > 0.0)) continue;
    const double wider = std::log(seen.half_width_px / holder.half_width);
    if (std::abs(wider) < kSameHolderWidth || (by_lines && wider < kOneWall)) return;
    holder.half_width = seen.half_width_px;
    holder.half_width_sigma = kSceneWidthSigma;
    return;
  }
}

}  // namespace

NeedleZone CellFollower::zone() const {
  const NeedleEstimate& n = needle_.estimate();
  // The front of a blurred tip is less sharp.
  const double tip_sigma = std::hypot(0.4, 0.5 * n.edge_blur);
  NeedleZone zone{n.tip, n.direction, n.tip_half_width + n.edge_blur, n.widening, touching_, tip_sigma};
  const double line = snakes_.line_width_px();
  zone.is_shade = line > 0.0 && n.edge_blur > kShade_ratio * line;
  return zone;
}

void CellFollower::find_tools_of(const FrameInput& frame, const contour::Circle& circle) {
  const std::vector<FoundTool> tools = find_tools(gray(frame.view), circle);
  motion_ = {};
  const auto find_among = [&](const std::vector<FoundTool>& candidates) {
    holder_ = find_holder(frame.image, candidates, circle, frame.noise);
    if (holder_ && frame.seen) check_width(*holder_, *frame.seen, !frame.scene);
  };
  find_among(frame.seen ? holders_among(tools, *frame.seen, !frame.scene) : tools);
  find_needle(frame, circle, tools);
  if (frame.scene && frame.networks) settle_facing(frame, circle, tools);
  // The scene may show a broad shaft as both: the needle holds nothing.
  if (holder_ && is_along_needle(*holder_, circle.center)) {
    std::vector<FoundTool> others;
    std::copy_if(tools.begin(), tools.end(), std::back_inserter(others), [&](const FoundTool& tool) {
      return -tool.direction.dot(needle_.estimate().direction) < kAlongHolder;
    });
    find_among(others);
  }
  if (!holder_) find_facing_holder(frame, circle, tools);
  begin_watch(frame, circle);
  begin_command(frame);
  read_tip_width(frame, false);
}

// What faces the needle holds the cell, however narrow: the scene takes such a pipette for another needle.
void CellFollower::find_facing_holder(const FrameInput& frame, const contour::Circle& circle,
                                      const std::vector<FoundTool>& tools) {
  if (!needle_.valid()) return;
  std::vector<FoundTool> facing;
  std::copy_if(tools.begin(), tools.end(), std::back_inserter(facing),
               [&](const FoundTool& tool) { return tool.direction.dot(needle_.estimate().direction) > kAlongHolder; });
  holder_ = find_holder(frame.image, facing, circle, frame.noise, kNarrowestFacing_ratio);
}

// The tool taken for the holder goes with the needle: it is the needle.
void CellFollower::find_holder_anew(const FrameInput& frame) {
  holder_.reset();
  const contour::Circle circle = resting_circle();
  find_facing_holder(frame, circle, find_tools(gray(frame.view), circle));
}

// False, and all as before, where no needle is found in its place.
bool CellFollower::take_holder_for_needle(const FrameInput& frame) {
  const contour::Circle circle = resting_circle();
  const std::vector<FoundTool> tools = find_tools(gray(frame.view), circle);
  const auto is_needle = [&](const FoundTool& tool) {
    return tool.direction.dot(holder_direction()) > kAlongHolder && needle_.start(frame.image, tool, frame.noise) &&
           needle_.estimate().tip_half_width < kFacingTip_ratio * circle.radius;
  };
  if (std::none_of(tools.begin(), tools.end(), is_needle)) {
    needle_.reset();
    return false;
  }
  holder_.reset();
  find_facing_holder(frame, circle, tools);
  begin_command(frame);
  return true;
}

// Two tools from the same side that overlap are one.
bool CellFollower::is_along_needle(const HolderFit& holder, const Eigen::Vector2d& center) const {
  const NeedleEstimate& n = needle_.estimate();
  return needle_.valid() && is_along(holder, n, center, 1.0 + n.tip_half_width / holder.half_width);
}

// By lines alone; or, where the scene was read, one of its needles, by lines where those show the same.
void CellFollower::find_needle(const FrameInput& frame, const contour::Circle& circle,
                               const std::vector<FoundTool>& tools) {
  // What points at the pipette that holds the cell may be blunt.
  const auto is_plausible = [&] {
    const bool faces = holder_ && needle_.estimate().direction.dot(holder_direction()) > kAlongHolder;
    return needle_.estimate().tip_half_width < (faces ? kFacingTip_ratio : kBroadTip_ratio) * circle.radius &&
           is_before(needle_.estimate(), circle.center, kThrough_ratio * circle.radius) && comes_as_before();
  };
  const auto is_needle = [&](const FoundTool& tool, const ExpectedTip* expected, double scene_half_width_px) {
    if (tool.half_width() >= kBroadTool_ratio * circle.radius) return false;
    if (!needle_.start(frame.image, tool, frame.noise, expected)) return false;
    needle_.expect_half_width(scene_half_width_px);
    if (frame.scene && frame.networks) needle_.find_tip(frame.networks->tips(), frame.image, circle.center);
    return is_plausible();
  };
  if (frame.scene == nullptr) {
    for (const FoundTool& tool : tools)
      if (!(holder_ && tool.direction.dot(holder_direction()) > 0.8) && is_needle(tool, nullptr, 0.0)) return;
  } else {
    for (const SceneTool& seen : frame.scene->needles) {
      const ExpectedTip expected = expected_tip(seen);
      // Dark lines may be those of one wall alone; in other looks the network reads the tip.
      const auto is_whole = [&] { return frame.reader != nullptr || !is_one_wall(needle_.estimate(), seen); };
      for (const FoundTool& tool : tools)
        if (is_same(tool, seen) && is_needle(tool, &expected, seen.half_width_px) && is_whole()) return;
      if (is_needle(found_tool(seen), &expected, seen.half_width_px)) return;
      if (frame.networks && start_by_tip(needle_, frame, seen, circle.center) && is_plausible()) return;
    }
  }
  needle_.reset();
}

// What holds the cell may look like a needle, but not like the one that was lost.
bool CellFollower::comes_as_before() const {
  return !needle_way_ || unseen_frames_ > kRemembered_frames ||
         needle_.estimate().direction.dot(*needle_way_) > kSameWay;
}

contour::Circle CellFollower::resting_circle() const {
  return {center_now(), zona_.valid() ? zona_.rest_radius() : rest_.outer_radius, 1.0, 0.0};
}

bool CellFollower::expect_needle(const FrameInput& frame, const Eigen::Vector2d& tip) {
  NeedleTracker found;
  if (!start_at_hint(found, frame, find_tools(gray(frame.view), resting_circle()), tip)) return false;
  if (frame.reader) found.read_tip(frame.reader->tips(), frame.image, 1.0);
  needle_ = std::move(found);
  rival_.reset();
  return true;
}

bool CellFollower::expect_holder(const FrameInput& frame, const Eigen::Vector2d& place) {
  const contour::Circle circle = resting_circle();
  const auto found = find_holder_at(frame, find_tools(gray(frame.view), circle), circle, place);
  if (!found) return false;
  holder_ = found;
  rival_.reset();
  if (frame.seen) check_width(*holder_, *frame.seen, !frame.scene);
  // It was found in this frame, and the cell at rest is where it is now.
  rest_now_at(center_now());
  walls_slide_ = false;
  learn_holder_motion(frame);
  return true;
}

void CellFollower::expect_needle_width(double half_width_px, const FrameSampler& image, TipNetwork& network) {
  needle_.expect_half_width(half_width_px);
  needle_.read_tip(network, image, 1.0);
}

bool CellFollower::take_bevel(const FrameSampler& image, TipNetwork& network) {
  return contact_.state() == CellState::kFree && needle_.take_bevel(network, image);
}

// What of the picture the cell's membrane and its halo take.
contour::Circle CellFollower::reach_of_cell() const {
  contour::Circle circle = resting_circle();
  circle.radius += kHaloLines * snakes_.line_width_px();
  return circle;
}

NeedleCue CellFollower::needle_cue(const FrameInput& frame, const Eigen::Vector2d& shift) {
  const NeedleEstimate& n = needle_.estimate();
  const double clear_px = kClear_px + kClearBlurs * std::max(0.0, n.edge_blur - kSharp_px);
  NeedleCue cue;
  cue.in_the_clear = contact_.state() == CellState::kFree && tip_depth() < -clear_px;
  cue.command = frame.command;
  cue.is_quick = options_.quality == TrackerOptions::Quality::kLive;
  cue.scene_jump_px = scene_jump_;
  cue.is_free = contact_.state() == CellState::kFree && tip_depth() < -kUntouched_px;
  cue.covered_px = kBeyondCell_px + std::max(0.0, tip_depth());
  if (zone().is_shade) cue.body = reach_of_cell();
  // Through the membrane, its line crosses the shaft and says nothing about the end.
  if (cue.in_the_clear || cue.body || contact_.state() == CellState::kPunctured) return cue;
  snakes_.show_behind(n.tip + scene_jump_, shift, touching_ ? wrapped_px(n.tip_half_width) : 0.0, backdrop_);
  cue.depth_px = tip_depth();
  if (!backdrop_.is_empty()) cue.membrane = &backdrop_;
  return cue;
}

void CellFollower::follow_needle(const FrameInput& frame, const Eigen::Vector2d& shift) {
  const PartTimer timer(frame.timings->needle_us);
  if (needle_.valid()) {
    const NeedleCue cue = needle_cue(frame, shift);
    const Eigen::Vector2d before = needle_.motion();
    bool seen = needle_.is_read() ? needle_.follow_read(frame.networks->tips(), frame.image, cue)
                                  : needle_.track(frame.image, frame.noise, cue);
    // Lines whose end leaps, or is seen poorly, may have lost it; in a dimple the networks know it no better.
    const bool is_free = contact_.state() == CellState::kFree;
    const bool is_leap = (needle_.motion() - before).norm() > kCheckedLeap_px + 0.5 * before.norm();
    const bool is_poor = !seen || needle_.estimate().confidence < kPoorNeedle || (is_free && is_leap);
    const bool is_pushing = contact_.state() == CellState::kContact;
    const bool is_doubtful = is_needle_doubtful_ || (is_doubtful_ && !is_pushing);
    const bool is_asked = frame.networks && (is_read_ || is_doubtful || is_poor);
    if (!seen && is_asked) seen = needle_.go_on_read(frame.networks->tips(), frame.image);
    if (!is_before(needle_.estimate(), center_now(), kThrough_ratio * rest_.outer_radius)) needle_.reset();
    if (!seen && needle_.estimate().confidence < 0.1) needle_.reset();
    // Lines are the more precise, unless the tip lies elsewhere.
    const bool is_elsewhere =
        is_read_ || (is_asked && !zone().is_shade && !needle_.is_where_read(frame.networks->tips(), frame.image));
    if (is_asked && is_elsewhere && !needle_.is_read()) {
      if (is_free) {
        needle_.read_tip(frame.networks->tips(), frame.image, 1.0, &cue);
      } else {
        needle_.read_tip_in_contact(frame.networks->tips(), frame.image, cue, is_pushing ? frame.command : nullptr);
      }
    }
    compare_with_command(frame, seen);
    read_tip_width(frame, is_free);
  } else if (frame.scene || (frame.reader == nullptr && (frames_followed_ % 3 == 0 || frames_followed_ < 10))) {
    const contour::Circle circle = resting_circle();
    find_needle(frame, circle, find_tools(gray(frame.view), circle));
    begin_watch(frame, circle);
    begin_command(frame);
  }
  unseen_frames_ = needle_.valid() ? 0 : unseen_frames_ + 1;
  if (needle_.valid()) needle_way_ = needle_.estimate().direction;
}

// Not seen, or misread in contact, it is where it was sent.
void CellFollower::compare_with_command(const FrameInput& frame, bool is_seen) {
  if (!frame.command || !needle_.valid()) return;
  const NeedleEstimate& n = needle_.estimate();
  const bool is_misread =
      contact_.state() == CellState::kContact && is_seen && frame.command->contradicts(n.tip, n.tip_sigma);
  if (is_seen && !is_misread) return frame.command->learn(n.tip, n.direction, n.tip_sigma, false);
  if (is_misread) frame.command->misread();
  if (const auto due = frame.command->due(n.tip)) needle_.hold(*due);
}

// A needle that was found just now.
void CellFollower::begin_command(const FrameInput& frame) {
  if (!frame.command || !needle_.valid()) return;
  const NeedleEstimate& n = needle_.estimate();
  frame.command->learn(n.tip, n.direction, n.tip_sigma, true);
}

// Where the membrane does not lie about the tip; in contact only if it was never read before.
void CellFollower::read_tip_width(const FrameInput& frame, bool is_clear) {
  const bool is_first = needle_.valid() && !needle_.is_width_read();
  if (frame.networks != nullptr && (is_first || (is_clear && frames_followed_ % kWidth_frames == kWidthFrame)))
    needle_.read_width(frame.networks->tip_widths(), frame.image);
}

// Through a needle that is a mere shade the membrane is seen, and its apex rests on the tip.
void CellFollower::take_dimple() {
  if (contact_.state() != CellState::kContact || !needle_.valid() || !zone().is_shade) return;
  needle_.take_dimple(apex(), apex_sigma());
}

Eigen::Vector2d CellFollower::apex() const {
  return entry_point() + membrane_depth_ * needle_.estimate().direction;
}

double CellFollower::apex_sigma() const {
  return std::hypot(membrane_sigma(), kApexSigma_px);
}

}  // namespace pellucida
