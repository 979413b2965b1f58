#include "CrossedCell.h"

#include <algorithm>
#include <cmath>

#include "FacingTools.h"

namespace pellucida {
namespace {

// Least share of the network's answer in one place. So far beside the needle's line, in its half widths and radii of
// the crossed cell, its tip may be read: the line is known from the part before that cell. Looked at on validation
// films 54884 and 55062.
constexpr double kSureTip = 0.85, kBesideHalfWidths = 3.0, kBeside_ratio = 0.15;

double across_px(const Eigen::Vector2d& way, const Eigen::Vector2d& direction) {
  return std::abs(way.x() * direction.y() - way.y() * direction.x());
}

}  // namespace

void look_past(SceneReading& scene, const contour::Circle& crossed, const FrameSampler& image, TipNetwork& tips) {
  for (SceneTool& needle : scene.needles) {
    const Eigen::Vector2d to_crossed = crossed.center - needle.tip;
    const double crossed_px = to_crossed.dot(needle.direction);
    if (!points_into(needle, crossed.center, crossed.radius)) continue;
    const double most_beside_px = std::max(kBesideHalfWidths * needle.half_width_px, kBeside_ratio * crossed.radius);
    for (const SceneCell& cell : scene.cells) {
      const Eigen::Vector2d to_cell = cell.center - needle.tip;
      const double ahead_px = to_cell.dot(needle.direction), aside_px = across_px(to_cell, needle.direction);
      if (aside_px > cell.radius_px || ahead_px < crossed_px + crossed.radius) continue;
      const double entry_px = ahead_px - std::sqrt(cell.radius_px * cell.radius_px - aside_px * aside_px);
      const NeedleAxis entry{needle.tip + entry_px * needle.direction, needle.direction};
      const TipReading seen = tips.find(image, entry, needle.half_width_px, cell.center);
      const bool is_past = (seen.tip - crossed.center).dot(needle.direction) > kThrough_ratio * crossed.radius;
      if (seen.share < kSureTip || !is_past || across_px(seen.tip - needle.tip, needle.direction) > most_beside_px)
        continue;
      needle.tip = seen.tip;
      needle.tip_share = seen.share;
      break;
    }
  }
}

}  // namespace pellucida
