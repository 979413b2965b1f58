// What lies over the 3-D view: scales, notes, values of the bold arrows, marks.
#include <vtkCamera.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "AxesTriad.h"
#include "ColorMap.h"
#include "FeedMarks.h"
#include "MembraneActors.h"
#include "ToolShapes.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization_vtk/MembraneView.h"

namespace pellucida {
namespace {

constexpr double kNoteRow_px = 20.0;

std::string why_empty(const Scene& scene) {
  if (!scene.observation) return say("Waiting for a cell");
  return scene.observation->outer ? say("No surface: the contour can't be revolved") : say("No cell in sight");
}

}  // namespace

void MembraneView::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  const ThemeColors& theme = current_theme();
  if (!has_surface_) {
    hud.text(0.5 * width_px, 0.5 * height_px, empty_text_.empty() ? why_empty(source_->GetScene()) : empty_text_,
             {.size_pt = font_size::kTitle, .color = theme.text_dim, .align = HudAlign::kCentre});
    return;
  }
  draw_inside(hud);
  draw_droplets(hud);
  draw_scales(hud, width_px, height_px);
  draw_axes_triad(hud, main_->GetActiveCamera());
  for (const BoldArrow* arrow : {&actors_->needle_force, &actors_->holder_force}) draw_bold_arrow(hud, *arrow);
  draw_node_mark(hud);
}

void MembraneView::draw_scales(HudCanvas& hud, double width_px, double height_px) {
  const ThemeColors& theme = current_theme();
  const double time_s = source_->GetScene().measurement.time_s;
  const double bar_height = std::clamp(0.38 * height_px, 90.0, 220.0);
  const double bar_y = height_px - bar_height - 46.0;
  const auto tell_growth = [&](const Scale& scale, double x, double y, HudAlign align) {
    if (!scale.is_news(time_s)) return;
    hud.text(x, y, say("Scale grew, was ") + readout::plain(scale.before), {.color = theme.warning, .align = align});
  };
  const double notes_y = bar_y - kNoteRow_px;
  if (arrows_shown_ && has_forces_ && has_unsure_ && !has_sure_) {
    // No colour is used: under a tool only the sum is known, which the bold arrow shows.
    // In the corner that the needle doesn't come from.
    const Scene& scene = source_->GetScene();
    const bool from_above = scene.observation && scene.observation->axis.y() < -0.3;
    const double y = from_above ? 16.0 + kNoteRow_px * (1 + static_cast<int>(bars_shown_)) : height_px - 26.0;
    hud.text(width_px - 16.0, y, node_force_legend(node_force()), {.color = theme.text, .align = HudAlign::kRight});
    draw_arrow_notes(hud, width_px - 16.0, y - kNoteRow_px);
  } else if (arrows_shown_ && has_forces_) {
    const Scale& scale = force_scale();
    draw_color_bar(hud, ColorMapKind::kForce, width_px - 16.0, bar_y, bar_height, scale.range.upper(),
                   node_force_legend(node_force()), HudAlign::kRight, scale.beyond);
    draw_arrow_notes(hud, width_px - 16.0, notes_y);
    const int note_count = static_cast<int>(has_unsure_) + static_cast<int>(bars_shown_);
    tell_growth(scale, width_px - 16.0, notes_y - note_count * kNoteRow_px, HudAlign::kRight);
  } else if (arrows_shown_ && lacks_force_) {
    const HudText style{.color = theme.text_dim, .align = HudAlign::kRight};
    hud.text(width_px - 16.0, height_px - 26.0, node_force_legend(node_force()),
             {.color = theme.text, .align = HudAlign::kRight});
    hud.text(width_px - 16.0, height_px - 46.0, say("not in this recording: measure it again,"), style);
    hud.text(width_px - 16.0, height_px - 64.0, say("or choose the membrane resultant"), style);
  }
  if (coloring_available_) {
    const Scale& scale = color_scale();
    draw_color_bar(hud, is_signed(coloring_) ? ColorMapKind::kPull : ColorMapKind::kSurface, 16.0, bar_y, bar_height,
                   scale.range.upper(), coloring_legend(coloring_), HudAlign::kLeft, scale.beyond);
    tell_growth(scale, 16.0, notes_y, HudAlign::kLeft);
  } else if (coloring_ != SurfaceColoring::kPlain) {
    hud.text(16.0, height_px - 26.0, coloring_legend(coloring_), {.color = theme.text});
    hud.text(16.0, height_px - 46.0, say("not measured in this frame"), {.color = theme.text_dim});
  }
}

// Below the arrows' scale, ending at `x`: what grey and the bars mean.
void MembraneView::draw_arrow_notes(HudCanvas& hud, double x, double y) {
  const ThemeColors& theme = current_theme();
  // On a plate: the cell may lie behind.
  constexpr double kSign_px = 24.0;
  const auto note = [&](const std::string& text) {
    const HudText style{.color = theme.text, .align = HudAlign::kRight};
    const double width = hud.text_width_px(text, style);
    hud.rounded(x - width - kSign_px - 14.0, y - 10.0, width + kSign_px + 20.0, 20.0, 4.0, theme.window, 0.6);
    hud.text(x, y, text, style);
    return x - width - 8.0;
  };
  if (has_unsure_) {
    const double end = note(has_sure_ ? say("may be zero (95 %)") : say("each alone may be zero (95 %)"));
    hud.rectangle(end - 12.0, y - 6.0, 12.0, 12.0, theme.unsure);
    y -= kNoteRow_px;
  }
  if (bars_shown_) {
    const double end = note(say("95 % interval"));
    hud.rectangle(end - 20.0, y - 0.75, 20.0, 1.5, theme.text);
    for (const double at : {end - 20.0, end - 1.5}) hud.rectangle(at, y - 4.0, 1.5, 8.0, theme.text);
  }
}

// What the cell would hide: the plan, and the needle once it is in.
void MembraneView::draw_inside(HudCanvas& hud) const {
  const ThemeColors& theme = current_theme();
  const auto place = [&](const Eigen::Vector2d& um) {
    const double world_um[3] = {um.x(), um.y(), 0.0};
    const auto [x, y] = to_hud(world_um);
    return Eigen::Vector2d(x, y);
  };
  if (plan_) draw_plan(hud, *plan_, place, theme.plan, theme.window);
  const auto needle = needle_of(source_->GetScene());
  if (!punctured_ || !tools_shown_ || !needle) return;
  const Eigen::Vector2d tip = place(needle->tip_um), back = place(needle->tip_um - radius_um_ * needle->direction);
  hud.line(tip.x(), tip.y(), back.x(), back.y(), 1.5, theme.needle, 0.9);
  hud.disc(tip.x(), tip.y(), 5.5, theme.window, 0.75);
  hud.disc(tip.x(), tip.y(), 4.0, theme.needle);
}

// Each with its volume, at its lower right.
void MembraneView::draw_droplets(HudCanvas& hud) const {
  const ThemeColors& theme = current_theme();
  for (const DropletMark& droplet : droplets_) {
    const auto [x, y] = to_hud(droplet.center_um.data());
    const HudText style{.color = theme.droplet, .bold = true};
    const double width = hud.text_width_px(droplet.text, style);
    hud.rounded(x + 9.0, y + 8.0, width + 12.0, 20.0, 4.0, theme.window, 0.7);
    hud.text(x + 15.0, y + 18.0, droplet.text, style);
  }
}

void MembraneView::draw_bold_arrow(HudCanvas& hud, const BoldArrow& arrow) const {
  if (arrow.label.empty()) return;
  const ThemeColors& theme = current_theme();
  const auto [x, y] = to_hud(arrow.tail_um.data());
  const auto [head_x, head_y] = to_hud(arrow.head_um.data());
  // Seen from its end an arrow is a mere disc: a dot for one that points at the eye, a cross for one that points away.
  constexpr double kShortest_px = 22.0, kRing_px = 11.0, kCross_px = 6.0;
  if (std::hypot(head_x - x, head_y - y) < kShortest_px) {
    double eye_um[3];
    main_->GetActiveCamera()->GetPosition(eye_um);
    const Eigen::Vector3d to_eye = Eigen::Map<const Eigen::Vector3d>(eye_um) - arrow.head_um;
    const double along = (arrow.head_um - arrow.tail_um).dot(to_eye);
    if (std::abs(along) > 0.8 * (arrow.head_um - arrow.tail_um).norm() * to_eye.norm()) {
      const double at_x = 0.5 * (x + head_x), at_y = 0.5 * (y + head_y);
      hud.disc(at_x, at_y, kRing_px + 2.0, theme.window, 0.9);
      hud.disc(at_x, at_y, kRing_px, theme.contact_force);
      hud.disc(at_x, at_y, kRing_px - 2.5, theme.window);
      if (along > 0.0) {
        hud.disc(at_x, at_y, 3.5, theme.contact_force);
      } else {
        hud.line(at_x - kCross_px, at_y - kCross_px, at_x + kCross_px, at_y + kCross_px, 2.5, theme.contact_force);
        hud.line(at_x - kCross_px, at_y + kCross_px, at_x + kCross_px, at_y - kCross_px, 2.5, theme.contact_force);
      }
    }
  }
  const HudText style{.size_pt = font_size::kTitle, .color = theme.text, .bold = true, .align = HudAlign::kCentre};
  const double width = hud.text_width_px(arrow.label, style) + 18.0;
  hud.rounded(x - 0.5 * width, y + 22.0, width, 26.0, 5.0, theme.window, 0.78);
  // The letters' box reaches below the line: optically in the middle.
  hud.text(x, y + 33.5, arrow.label, style);
}

void MembraneView::draw_node_mark(HudCanvas& hud) const {
  vtkPolyData* surface = actors_->update_surface();
  if (!marked_node_ || *marked_node_ < 0 || *marked_node_ >= surface->GetNumberOfPoints()) return;
  const auto [x, y] = to_hud(surface->GetPoint(*marked_node_));
  hud.disc(x, y, 8.0, current_theme().window, 0.85);
  hud.disc(x, y, 6.0, current_theme().node_mark);
  hud.disc(x, y, 3.0, current_theme().window);
}

}  // namespace pellucida
