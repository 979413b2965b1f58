#include "SceneVerdict.h"

#include <algorithm>
#include <cmath>

namespace pellucida {
namespace {

// By experiment on random films in two styles (docs/method.md, 1.9): outlines of one cell differ by 6 % of its radius
// at most, tips of one needle by 10 px; membranes that are lines are seen with 0.83 or more; the network's score is
// 0.98 or more for looks like those it has learnt from, 0.95 or less for others, the lines' 0.999 for bubbles.
constexpr double kSameOutline_ratio = 0.07, kLeastApart_px = 2.5, kSameTip_px = 11.0;
constexpr double kLeastConfidence = 0.8, kFamiliarScore = 0.967, kBubbleScore = 0.99;

// Mean distance of an outline's points from the nearest points of a contour, px.
double distance_px(const Eigen::Matrix2Xd& outline, const Eigen::Matrix2Xd& contour) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < outline.cols(); ++i)
    sum += std::sqrt((contour.colwise() - outline.col(i)).colwise().squaredNorm().minCoeff());
  return sum / static_cast<double>(std::max<Eigen::Index>(1, outline.cols()));
}

bool is_same_cell(const CellFollower& by_lines, const SceneCell& seen) {
  const double radius_px = by_lines.rest().outer_radius;
  const double most_px = std::max(kLeastApart_px, kSameOutline_ratio * radius_px);
  return distance_px(seen.outer, by_lines.snakes().outer().points) < most_px;
}

}  // namespace

bool is_needle_confirmed(const CellFollower& by_lines, const SceneReading& scene) {
  const NeedleTracker& followed = by_lines.needle();
  bool has_tip = false;
  for (const SceneTool& needle : scene.needles) {
    if (needle.tip_share < kLeastNeedleTipShare) continue;
    has_tip = true;
    const double near_px = std::max(kSameTip_px, 2.0 * needle.half_width_px);
    if (followed.valid() && (needle.tip - followed.estimate().tip).norm() < near_px) return true;
  }
  return !has_tip;
}

bool confirms(const SceneReading& scene, const CellFollower& by_lines) {
  const bool is_seen = std::any_of(scene.cells.begin(), scene.cells.end(), [&](const SceneCell& seen) {
    return seen.share >= kLeastCellShare && is_same_cell(by_lines, seen);
  });
  return is_seen && is_needle_confirmed(by_lines, scene) && by_lines.confidence() > kLeastConfidence;
}

bool is_familiar(const CellFollower& by_scene) {
  return by_scene.snakes().outer().score > kFamiliarScore;
}

bool is_bubble(const CellFollower& by_lines, const SceneReading& scene) {
  const bool has_cell = std::any_of(scene.cells.begin(), scene.cells.end(),
                                    [](const SceneCell& seen) { return seen.share >= kLeastCellShare; });
  return !has_cell && by_lines.snakes().outer().score > kBubbleScore;
}

}  // namespace pellucida
