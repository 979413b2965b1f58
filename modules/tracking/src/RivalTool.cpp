#include "RivalTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellucida {
namespace {

// So far, px and of the cell's radius, a tip has moved against the cell; what rests has moved by less than this share
// of it. A cell goes towards its holder by 0.07 of a push at most (CellFollowerPlace). Looked at on wide film 311003.
constexpr double kGone_px = 3.0, kGone_ratio = 0.06, kRested_ratio = 0.33;
// Readings in a row that have to show it, with so much of the network's answer in one place; so many that don't show
// the tool at all end the watch.
constexpr int kReadings = 2, kMostUnseen = 4;
constexpr double kSureTip = 0.8;

double along_px(const NeedleEstimate& tool, const Eigen::Vector2d& center) {
  return (tool.tip - center).dot(tool.direction);
}

}  // namespace

void RivalTool::begin(NeedleTracker tool, const NeedleEstimate& needle, const contour::Circle& cell) {
  reset();
  tool_ = std::move(tool);
  center_ = cell.center;
  tool_start_px_ = along_px(tool_.estimate(), center_);
  needle_start_px_ = along_px(needle, center_);
}

RivalTool::Verdict RivalTool::watch(TipNetwork& tips, const FrameSampler& image, const NeedleEstimate& needle,
                                    const contour::Circle& cell) {
  NeedleCue cue;
  cue.scene_jump_px = cell.center - center_;
  center_ = cell.center;
  if (!tool_.follow_read(tips, image, cue)) {
    if (++times_unseen_ >= kMostUnseen) reset();
    return Verdict::kOpen;
  }
  times_unseen_ = 0;
  const double least_px = std::max(kGone_px, kGone_ratio * cell.radius), now_px = along_px(tool_.estimate(), center_);
  const double tool_way_px = now_px - tool_start_px_, needle_way_px = along_px(needle, center_) - needle_start_px_;
  if (std::abs(needle_way_px) > least_px && std::abs(tool_way_px) < kRested_ratio * std::abs(needle_way_px))
    return Verdict::kIsHolder;
  const bool is_in_cell = cell.radius + now_px > least_px;
  const bool has_gone = tool_way_px > least_px && std::abs(needle_way_px) < kRested_ratio * tool_way_px;
  const bool is_sure = tool_.estimate().confidence > kSureTip && tool_.estimate().tip_sigma < 0.5 * tool_way_px;
  times_gone_ = has_gone && is_in_cell && is_sure ? times_gone_ + 1 : 0;
  return times_gone_ < kReadings ? Verdict::kOpen : Verdict::kIsNeedle;
}

}  // namespace pellucida
