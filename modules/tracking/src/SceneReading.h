#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ContourMath.h"
#include "SceneNetwork.h"

namespace pellucida {

/// Least probability of a cell, and of a needle's tip, to count as one.
inline constexpr double kLeastCellShare = 0.6, kLeastNeedleTipShare = 0.5;

/// A cell as the network's map shows it: good to about half a map pixel.
struct SceneCell {
  Eigen::Matrix2Xd outer;  ///< (2 x n) px, closed, positive area: the zona's outer boundary
  Eigen::Matrix2Xd inner;  ///< (2 x n) px, the zona's inner boundary; empty where none is seen
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius_px = 0.0;  ///< of a circle of the same area
  double share = 0.0;      ///< 0..1: mean probability of being cell, over its area

  contour::Circle circle() const noexcept { return {center, radius_px, 1.0, 0.0}; }
};

/// A straight tool as the network's map shows it.
struct SceneTool {
  Eigen::Vector2d tip = Eigen::Vector2d::Zero();         ///< px: where it ends inside the image
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, from the image's border to the tip
  double half_width_px = 0.0;                            ///< median over its length
  double length_px = 0.0;
  double share = 0.0;      ///< 0..1: mean probability over its area
  double tip_share = 0.0;  ///< 0..1: largest probability of a tip near `tip`
  double pitch_px = 1.0;   ///< of the map it was read from
  bool is_short = false;  ///< a holding pipette bent, or with little of it in view: its direction is good to 20 degrees
};

/// What the map shows, each list with the most convincing one first.
struct SceneReading {
  std::vector<SceneCell> cells;
  std::vector<SceneTool> needles;
  std::vector<SceneTool> holders;
  bool has_tools() const noexcept { return !(needles.empty() && holders.empty()); }
};

/// Whether the needle's line ahead of its tip meets the circle.
bool points_into(const SceneTool& needle, const Eigen::Vector2d& center, double radius_px);

/// Whether a holding pipette ends at the circle or a needle points into it: the cell that is worked on, no bystander.
bool is_worked_on(const SceneReading& seen, const Eigen::Vector2d& center, double radius_px);

/// Cells, needles and holding pipettes of a map: connected areas of their classes, large enough to be one.
/// `image_width`, `image_height` in px tell which end of a tool lies at the border.
SceneReading read_scene(const SceneMap& map, int image_width, int image_height);

}  // namespace pellucida
