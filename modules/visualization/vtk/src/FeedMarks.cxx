#include "FeedMarks.h"

#include <algorithm>

#include "pellucida/core/RoundNumbers.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {

void draw_legend(HudCanvas& hud, const std::vector<LegendRow>& rows, double height_px) {
  if (rows.empty()) return;
  constexpr double kRow = 20.0;
  double text_width = 0.0;
  for (const LegendRow& row : rows) text_width = std::max(text_width, hud.text_width_px(row.text));
  const double plate_height = kRow * static_cast<double>(rows.size()) + 12.0;
  hud.rounded(10.0, height_px - 10.0 - plate_height, text_width + 52.0, plate_height, 6.0, palette::kWindow, 0.72);
  double y = height_px - 16.0 - 0.5 * kRow;
  for (const LegendRow& row : rows) {
    if (row.dashed) {
      for (const double x : {20.0, 28.0, 36.0}) hud.rectangle(x, y - 1.25, 5.0, 2.5, row.color);
    } else {
      hud.rectangle(20.0, y - 1.5, 22.0, 3.0, row.color);
    }
    hud.text(51.0, y, row.text);
    y -= kRow;
  }
}

void draw_scale_bar(HudCanvas& hud, double um_per_px) {
  const double length_um = nice_floor(130.0 * um_per_px);
  const double length = length_um / um_per_px;
  const std::string label = readout::plain(length_um) + " µm";
  hud.rounded(10.0, 10.0, length + 28.0, 40.0, 6.0, palette::kWindow, 0.72);
  hud.rectangle(24.0, 20.0, length, 3.0, palette::kText);
  hud.rectangle(24.0, 17.0, 1.5, 9.0, palette::kText);
  hud.rectangle(24.0 + length - 1.5, 17.0, 1.5, 9.0, palette::kText);
  hud.text(24.0 + 0.5 * length, 37.0, label, {.align = HudAlign::kCentre});
}

void draw_plan(HudCanvas& hud, const PlanMarks& plan, const ToHud& place) {
  constexpr double kDash = 7.0, kGap = 5.0, kBar = 8.0, kCross = 6.0;
  const Eigen::Vector2d start = place(plan.approach_um);
  const Eigen::Vector2d end = place(plan.target_um);
  const double length = (end - start).norm();
  if (!(length > 1.0)) return;
  const Eigen::Vector2d along = (end - start) / length;
  const Eigen::Vector2d across(-along.y(), along.x());

  if (plan.guided && plan.corridor_um > 0.0) {
    const double um = (plan.target_um - plan.approach_um).norm();
    const double width = 2.0 * plan.corridor_um * length / um;
    hud.line(start.x(), start.y(), end.x(), end.y(), width, palette::kPlan, 0.14);
  }
  for (double s = 0.0; s < length; s += kDash + kGap) {
    const Eigen::Vector2d a = start + s * along;
    const Eigen::Vector2d b = start + std::min(s + kDash, length) * along;
    hud.line(a.x(), a.y(), b.x(), b.y(), 1.5, palette::kPlan, 0.9);
  }
  const auto bar = [&](const Eigen::Vector2d& p_um, double half, double width) {
    const Eigen::Vector2d p = place(p_um);
    const Eigen::Vector2d a = p - half * across;
    const Eigen::Vector2d b = p + half * across;
    hud.line(a.x(), a.y(), b.x(), b.y(), width + 2.0, palette::kWindow, 0.6);
    hud.line(a.x(), a.y(), b.x(), b.y(), width, palette::kPlan);
  };
  bar(plan.entry_um, kBar, 2.0);
  bar(plan.depth_stop_um, 1.5 * kBar, 3.5);
  hud.disc(end.x(), end.y(), kCross + 2.0, palette::kWindow, 0.5);
  hud.line(end.x() - kCross, end.y(), end.x() + kCross, end.y(), 2.0, palette::kPlan);
  hud.line(end.x(), end.y() - kCross, end.x(), end.y() + kCross, 2.0, palette::kPlan);
}

void draw_tip(HudCanvas& hud, const NeedlePose& needle, const ToHud& place) {
  constexpr double kAhead_um = 22.0;
  const Eigen::Vector2d tip = place(needle.tip_um);
  const Eigen::Vector2d ahead = place(needle.tip_um + kAhead_um * needle.direction);
  hud.line(tip.x(), tip.y(), ahead.x(), ahead.y(), 1.25, palette::kNeedle, 0.8);
  hud.disc(tip.x(), tip.y(), 5.5, palette::kWindow, 0.75);
  hud.disc(tip.x(), tip.y(), 4.0, palette::kNeedle);
  hud.disc(tip.x(), tip.y(), 1.75, palette::kWindow);
}

}  // namespace pellucida
