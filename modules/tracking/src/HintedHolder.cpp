#include "HintedHolder.h"

#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

// How far beside the pipette's edges a person may point, px.
constexpr double kBeside_px = 6.0;
// Where nothing is known of it but the place: directions about the one from the cell's centre, and half widths, of the
// cell's radius.
constexpr double kTurns_deg[] = {0.0, -6.0, 6.0, -12.0, 12.0, -18.0, 18.0};
constexpr double kHalfWidths_ratio[] = {0.25, 0.35, 0.5, 0.7, 0.9};
// Below this the edges were not followed.
constexpr double kFollowed = 0.75;

// A pipette `half_width` to each side of an axis `offset` beside the cell's centre.
FoundTool tool_of(const contour::Circle& cell, const Eigen::Vector2d& direction, double offset, double half_width) {
  return {.origin = cell.center,
          .direction = direction,
          .offset_from = offset - half_width,
          .offset_to = offset + half_width,
          .strength = 3.0 * cell.radius};
}

}  // namespace

std::optional<HolderFit> find_holder_at(const FrameInput& frame, const std::vector<FoundTool>& tools,
                                        const contour::Circle& cell, const Eigen::Vector2d& place) {
  const Eigen::Vector2d from = place - cell.center;
  if (from.norm() < cell.radius) return std::nullopt;
  std::optional<HolderFit> best;
  const auto attempt = [&](const FoundTool& tool, double least_confidence) {
    if (from.dot(tool.direction) <= 0.0) return;
    const std::optional<HolderFit> found = find_holder(frame.image, {tool}, cell, frame.noise);
    if (!found || found->confidence < least_confidence) return;
    if (!passes(tool_of(cell, found->direction, found->offset, found->half_width), place, kBeside_px)) return;
    if (!best || found->confidence > best->confidence) best = found;
  };
  for (const FoundTool& tool : tools) attempt(tool, 0.0);
  if (frame.seen != nullptr) {
    for (const SceneTool& seen : frame.seen->holders) attempt(found_tool(seen), 0.0);
  }
  if (best) return best;
  for (const double turn_deg : kTurns_deg) {
    const double angle_rad = std::atan2(from.y(), from.x()) + turn_deg * std::numbers::pi / 180.0;
    const Eigen::Vector2d direction(std::cos(angle_rad), std::sin(angle_rad));
    const double offset = from.dot(Eigen::Vector2d(-direction.y(), direction.x()));
    for (const double ratio : kHalfWidths_ratio)
      attempt(tool_of(cell, direction, offset, ratio * cell.radius), kFollowed);
  }
  return best;
}

}  // namespace pellucida
