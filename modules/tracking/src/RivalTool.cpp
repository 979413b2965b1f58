#include "RivalTool.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pellucida {
namespace {

// So far, px and of the cell's radius, a tip has moved in the picture; what rests has moved by less than this share of
// it, and what goes into the cell by more of it against the cell: a holding pipette that carries one moves with it.
// Looked at on wide film 311003 and tuning film 314212, whose cell gives way at its narrow holder as at the needle.
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
  tool_start_ = tool_.estimate().tip;
  needle_start_ = needle.tip;
  in_cell_start_px_ = along_px(tool_.estimate(), center_);
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
  const NeedleEstimate& tool = tool_.estimate();
  const double least_px = std::max(kGone_px, kGone_ratio * cell.radius), now_px = along_px(tool, center_);
  const double tool_way_px = (tool.tip - tool_start_).dot(tool.direction);
  const double needle_way_px = (needle.tip - needle_start_).dot(needle.direction);
  if (std::abs(needle_way_px) > least_px && std::abs(tool_way_px) < kRested_ratio * std::abs(needle_way_px))
    return Verdict::kIsHolder;
  const bool is_in_cell = cell.radius + now_px > least_px;
  const bool has_gone = tool_way_px > least_px && std::abs(needle_way_px) < kRested_ratio * tool_way_px &&
                        now_px - in_cell_start_px_ > kRested_ratio * tool_way_px;
  const bool is_sure = tool.confidence > kSureTip && tool.tip_sigma < 0.5 * tool_way_px;
  times_gone_ = has_gone && is_in_cell && is_sure ? times_gone_ + 1 : 0;
  return times_gone_ < kReadings ? Verdict::kOpen : Verdict::kIsNeedle;
}

}  // namespace pellucida
