#include "HintedNeedle.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace pellucida {
namespace {

// How well a person points, px: so far from the tip along the needle, and so far beside it.
constexpr double kPointing_px = 12.0, kBesideTip_px = 6.0;
// Shafts tried through the place where no line leads: directions all round, and half widths in px.
constexpr int kShaftDirections = 90;
constexpr double kShaftHalfWidths_px[] = {2.5, 5.0, 9.0};

}  // namespace

bool start_at_hint(NeedleTracker& needle, const FrameInput& frame, const std::vector<FoundTool>& tools,
                   const Eigen::Vector2d& tip) {
  const ExpectedTip expected{tip, kPointing_px};
  NeedleTracker best;
  const auto attempt = [&](const FoundTool& tool) {
    NeedleTracker one;
    if (!one.start(frame.image, tool, frame.noise, &expected)) return;
    if (!best.valid() || one.estimate().confidence > best.estimate().confidence) best = std::move(one);
  };
  for (const FoundTool& tool : tools) {
    if (passes(tool, tip, kBesideTip_px)) attempt(tool);
  }
  const bool has_line = best.valid();
  for (int k = 0; k < kShaftDirections && !has_line; ++k) {
    const double angle_rad = 2.0 * std::numbers::pi * k / kShaftDirections;
    for (const double half_width_px : kShaftHalfWidths_px) {
      FoundTool tool;
      tool.origin = tip;
      tool.direction = {std::cos(angle_rad), std::sin(angle_rad)};
      tool.offset_to = half_width_px;
      tool.offset_from = -half_width_px;
      attempt(tool);
    }
  }
  needle = std::move(best);
  return needle.valid();
}

}  // namespace pellucida
