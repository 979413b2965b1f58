#include "FeedMarks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pellucida/core/RoundNumbers.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/EdgePointer.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {

namespace {

// On a dark underlay.
void draw_ring(HudCanvas& hud, const Eigen::Vector2d& at, double radius_px, const Color& color) {
  constexpr int kCorners = 24;
  for (const auto& [width_px, ink] : {std::pair{4.5, palette::kWindow}, std::pair{2.0, color}}) {
    for (int k = 0; k < kCorners; ++k) {
      const double from = 2.0 * std::numbers::pi * k / kCorners, to = 2.0 * std::numbers::pi * (k + 1) / kCorners;
      hud.line(at.x() + radius_px * std::cos(from), at.y() + radius_px * std::sin(from),
               at.x() + radius_px * std::cos(to), at.y() + radius_px * std::sin(to), width_px, ink);
    }
  }
}

}  // namespace

double draw_legend(HudCanvas& hud, const std::vector<LegendRow>& rows, double width_px, double height_px) {
  // A cell in the middle of the view, with the tools beside it, begins below about so much of its height.
  constexpr double kMostHeight = 0.27;
  constexpr double kRow = 20.0, kMargin = 10.0, kLine = 41.0, kGap = 12.0;
  if (rows.empty()) return 0.0;
  double text_width = 0.0;
  for (const LegendRow& row : rows) text_width = std::max(text_width, hud.text_width_px(row.text));
  const auto most = static_cast<std::size_t>(std::max(1.0, (kMostHeight * height_px - kMargin - 12.0) / kRow));
  const std::size_t column_count = (rows.size() + most - 1) / most;
  const std::size_t row_count = (rows.size() + column_count - 1) / column_count;
  const double column_width = kLine + text_width;
  const double plate_width = static_cast<double>(column_count) * (column_width + kGap) - 1.0;
  const double plate_height = kRow * static_cast<double>(row_count) + 12.0;
  if (plate_width + 2.0 * kMargin > width_px) return 0.0;
  hud.rounded(kMargin, height_px - kMargin - plate_height, plate_width, plate_height, 6.0, palette::kWindow, 0.72);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LegendRow& row = rows[k];
    const double x = 20.0 + static_cast<double>(k / row_count) * (column_width + kGap);
    const double y = height_px - 16.0 - (0.5 + static_cast<double>(k % row_count)) * kRow;
    if (row.dashed) {
      for (const double dash : {0.0, 8.0, 16.0}) hud.rectangle(x + dash, y - 1.25, 5.0, 2.5, row.color);
    } else {
      hud.rectangle(x, y - 1.5, 22.0, 3.0, row.color);
    }
    hud.text(x + 31.0, y, row.text, {.color = palette::kText});
  }
  return plate_width + kMargin;
}

void draw_scale_bar(HudCanvas& hud, double um_per_px) {
  const double length_um = nice_floor(130.0 * um_per_px);
  const double length = length_um / um_per_px;
  const std::string label = readout::plain(length_um) + " µm";
  hud.rounded(10.0, 10.0, length + 28.0, 40.0, 6.0, palette::kWindow, 0.72);
  hud.rectangle(24.0, 20.0, length, 3.0, palette::kText);
  hud.rectangle(24.0, 17.0, 1.5, 9.0, palette::kText);
  hud.rectangle(24.0 + length - 1.5, 17.0, 1.5, 9.0, palette::kText);
  hud.text(24.0 + 0.5 * length, 37.0, label, {.color = palette::kText, .align = HudAlign::kCentre});
}

void draw_plan(HudCanvas& hud, const PlanMarks& plan, const ToHud& place, const Color& line, const Color& under) {
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
    hud.line(start.x(), start.y(), end.x(), end.y(), width, line, 0.14);
  }
  for (double s = 0.0; s < length; s += kDash + kGap) {
    const Eigen::Vector2d a = start + s * along;
    const Eigen::Vector2d b = start + std::min(s + kDash, length) * along;
    hud.line(a.x(), a.y(), b.x(), b.y(), 1.5, line, 0.9);
  }
  const auto bar = [&](const Eigen::Vector2d& p_um, double half, double width) {
    const Eigen::Vector2d p = place(p_um);
    const Eigen::Vector2d a = p - half * across;
    const Eigen::Vector2d b = p + half * across;
    hud.line(a.x(), a.y(), b.x(), b.y(), width + 2.0, under, 0.6);
    hud.line(a.x(), a.y(), b.x(), b.y(), width, line);
  };
  bar(plan.entry_um, kBar, 2.0);
  bar(plan.depth_stop_um, 1.5 * kBar, 3.5);
  hud.disc(end.x(), end.y(), kCross + 2.0, under, 0.5);
  hud.line(end.x() - kCross, end.y(), end.x() + kCross, end.y(), 2.0, line);
  hud.line(end.x(), end.y() - kCross, end.x(), end.y() + kCross, 2.0, line);
  if (!plan.has_handles) return;
  for (const auto& [handle, at_um] :
       {std::pair{PlanHandle::kEntry, plan.entry_um}, std::pair{PlanHandle::kTarget, plan.target_um},
        std::pair{PlanHandle::kDepthStop, plan.depth_stop_um}}) {
    draw_ring(hud, place(at_um), handle == plan.handle ? 13.0 : 9.0, line);
  }
}

void draw_hint(HudCanvas& hud, const HintMark& mark, const ToHud& place) {
  const Eigen::Vector2d at = place(mark.place_um);
  if (mark.further_um.empty()) draw_ring(hud, at, 9.0, palette::kWarning);
  for (const auto& [width_px, color] : {std::pair{4.5, palette::kWindow}, std::pair{2.0, palette::kWarning}}) {
    Eigen::Vector2d start = place(mark.place_um);
    for (const Eigen::Vector2d& further_um : mark.further_um) {
      const Eigen::Vector2d to = place(further_um);
      hud.line(start.x(), start.y(), to.x(), to.y(), width_px, color);
      hud.disc(start.x(), start.y(), width_px + 1.0, color);
      hud.disc(to.x(), to.y(), width_px + 1.0, color);
      start = to;
    }
  }
  if (mark.text.empty()) return;
  const HudText style{.color = palette::kWarning, .bold = true};
  const double width = hud.text_width_px(mark.text, style) + 12.0;
  Eigen::Vector2d left(at.x() + 14.0, at.y());
  if (!mark.further_um.empty()) {
    // Beside the middle of a distance, or outside an angle's vertex.
    const Eigen::Vector2d next = place(mark.further_um.front());
    const Eigen::Vector2d leg = (at - next).stableNormalized();
    Eigen::Vector2d away(-leg.y(), leg.x());
    if (away.y() < 0.0) away = -away;
    Eigen::Vector2d middle = 0.5 * (at + next);
    if (mark.further_um.size() > 1) {
      const Eigen::Vector2d between = leg + (place(mark.further_um.back()) - next).stableNormalized();
      if (between.norm() > 0.1) away = -between.normalized();
      middle = next;
    }
    const Eigen::Vector2d centre =
        middle + (10.0 + 0.5 * (std::abs(away.x()) * width + std::abs(away.y()) * 20.0)) * away;
    left = {centre.x() - 0.5 * width, centre.y()};
  }
  hud.rounded(left.x(), left.y() - 10.0, width, 20.0, 4.0, palette::kWindow, 0.8);
  hud.text(left.x() + 6.0, left.y(), mark.text, style);
}

void draw_needle_pointer(HudCanvas& hud, const Eigen::Vector2d& tip_um, const ToHud& place, double width_px,
                         double height_px, double um_per_px) {
  constexpr double kMargin_px = 14.0, kArrow_px = 26.0, kGap_px = 10.0, kPlate_px = 28.0;
  const auto pointer = edge_pointer(place(tip_um), width_px, height_px, kMargin_px);
  if (!pointer) return;
  const Eigen::Vector2d along = pointer->direction, across(-along.y(), along.x());
  const Eigen::Vector2d tail = pointer->at - kArrow_px * along;
  const auto stroke = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    hud.line(a.x(), a.y(), b.x(), b.y(), 8.0, palette::kWindow, 0.9);
    hud.line(a.x(), a.y(), b.x(), b.y(), 4.0, palette::kNeedle);
  };
  const Eigen::Vector2d barb = pointer->at - 11.0 * along;
  stroke(tail, pointer->at);
  stroke(barb + 9.0 * across, pointer->at);
  stroke(barb - 9.0 * across, pointer->at);
  const std::string words =
      say("Needle ") + readout::number(pointer->beyond * um_per_px, 0) + say(" µm beyond the edge");
  const HudText style{.size_pt = font_size::kTitle, .color = palette::kText, .bold = true};
  const double width = hud.text_width_px(words, style) + 20.0;
  const Eigen::Vector2d middle =
      tail - (kGap_px + 0.5 * (std::abs(along.x()) * width + std::abs(along.y()) * kPlate_px)) * along;
  const double left = std::clamp(middle.x() - 0.5 * width, 4.0, std::max(4.0, width_px - width - 4.0));
  const double bottom = std::clamp(middle.y() - 0.5 * kPlate_px, 4.0, std::max(4.0, height_px - kPlate_px - 4.0));
  hud.rounded(left, bottom, width, kPlate_px, 6.0, palette::kWindow, 0.85);
  hud.text(left + 10.0, bottom + 0.5 * kPlate_px, words, style);
}

void draw_prompt(HudCanvas& hud, const std::string& text, double width_px, double height_px) {
  const HudText style{
      .size_pt = font_size::kTitle, .color = palette::kWindow, .bold = true, .align = HudAlign::kCentre};
  const double width = hud.text_width_px(text, style) + 28.0;
  hud.rounded(0.5 * (width_px - width), height_px - 48.0, width, 34.0, 8.0, palette::kWarning, 0.95);
  hud.text(0.5 * width_px, height_px - 31.0, text, style);
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
