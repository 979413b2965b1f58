#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ContourMath.h"
#include "FrameSampler.h"
#include "ToolFinder.h"

namespace pellucida {

/// The holding pipette, px.
struct HolderFit {
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, from the cell's centre along the pipette
  double offset = 0.0;                                   ///< its axis beside the centre, across `direction`
  double half_width = 0.0;                               ///< to the outlines of its outer edges
  double half_width_sigma = 0.0;                         ///< standard deviation of its logarithm; 0: as edges show it
  double unevenness = 1.0;                               ///< `NeedleLook::unevenness` of the edges that show it
  Eigen::Vector2d mouth = Eigen::Vector2d::Zero();       ///< on its axis, where the glass ends
  bool mouth_seen = false;  ///< false: the glass fades into something else, and the mouth is where the cell's circle is
  double confidence = 0.0;  ///< 0..1
};

/// Finds the holder among the tools round a cell: the strongest of those whose half width is at least that share of the
/// cell's radius; not one that a much broader tool faces, which is a needle.
/// Its two outer edges are followed inwards as a needle's are (NeedleStart), which gives axis and width; the mouth is
/// where the cross-section just outside the cell stops being found again, going towards the cell. Nothing when no tool
/// is broad enough or none shows two edges.
std::optional<HolderFit> find_holder(const FrameSampler& image, const std::vector<FoundTool>& tools,
                                     const contour::Circle& cell, double noise, double least_ratio = 0.2);

}  // namespace pellucida
