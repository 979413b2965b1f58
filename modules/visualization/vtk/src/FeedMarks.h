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

/// The lines drawn, named, in the upper left corner; nothing for no rows.
void draw_legend(HudCanvas& hud, const std::vector<LegendRow>& rows, double height_px);

/// A bar of a round length in the lower left corner.
void draw_scale_bar(HudCanvas& hud, double um_per_px);

/// The planned way dashed, its corridor as a faint band while the guide is on, a bar across it at entry and depth stop,
/// a cross at the target.
void draw_plan(HudCanvas& hud, const PlanMarks& plan, const ToHud& place);

/// The needle's tip as a ring, and its axis ahead of the tip as a thin line.
void draw_tip(HudCanvas& hud, const NeedlePose& needle, const ToHud& place);

}  // namespace pellucida
