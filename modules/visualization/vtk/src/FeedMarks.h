#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "pellucida/core/Observation.h"
#include "pellucida/visualization/PlanMarks.h"
#include "pellucida/visualization_vtk/FeedView.h"

namespace pellucida {

// What lies over the feed's picture: legend, scale bar, plan, tip. All sizes in logical pixels.

/// Where a point of the image plane, um, lies in the viewport.
using ToHud = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

/// The lines drawn, named, in the upper left corner: below each other, and in columns where that would reach down to
/// the cell; left out where no room is left for that either. Returns its width with its margin; 0 for none.
double draw_legend(HudCanvas& hud, const std::vector<LegendRow>& rows, double width_px, double height_px);

/// A bar of a round length in the lower left corner.
void draw_scale_bar(HudCanvas& hud, double um_per_px);

/// The planned way dashed, its corridor as a faint band while the guide is on, a bar across it at entry and depth stop,
/// a cross at the target. In `line`'s colour, on an underlay of `under`.
void draw_plan(HudCanvas& hud, const PlanMarks& plan, const ToHud& place, const Color& line = palette::kPlan,
               const Color& under = palette::kWindow);

/// Where a person pointed: a ring with a word beside it.
void draw_hint(HudCanvas& hud, const HintMark& mark, const ToHud& place);

/// An arrow at the view's edge, in words how far the needle is beyond it. `um_per_px`: of the view.
void draw_needle_pointer(HudCanvas& hud, const Eigen::Vector2d& tip_um, const ToHud& place, double width_px,
                         double height_px, double um_per_px);

/// What a click is waited for, in the middle at the top.
void draw_prompt(HudCanvas& hud, const std::string& text, double width_px, double height_px);

/// The needle's tip as a ring, and its axis ahead of the tip as a thin line.
void draw_tip(HudCanvas& hud, const NeedlePose& needle, const ToHud& place);

}  // namespace pellucida
