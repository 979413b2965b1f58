#pragma once
#include <Eigen/Core>
#include <vector>

#include "ContourMath.h"
#include "GrayImage.h"

namespace pellucida {

/// A straight tool that reaches the cell from the image's border, as the line voting sees it (full image px).
struct FoundTool {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< the point the offsets are counted from: the cell's centre
  Eigen::Vector2d direction;                         ///< unit, from the cell's centre outwards along the tool
  double offset_from = 0.0;  ///< signed distances of its outermost edges from the cell's centre, across `direction`
  double offset_to = 0.0;    ///< (positive towards (-direction.y, direction.x)); from <= to
  double strength = 0.0;     ///< px of edge that support it
  double width_sigma = 0.0;  ///< standard deviation of its width's logarithm; 0: as edges show it

  double offset() const noexcept { return 0.5 * (offset_from + offset_to); }
  double half_width() const noexcept { return 0.5 * (offset_to - offset_from); }
};

/// Whether it passes at `place`, up to `beside_px` outside its edges; on either side of its origin.
bool passes(const FoundTool& tool, const Eigen::Vector2d& place, double beside_px);

/// Straight edges outside the cell, by voting of gradient pixels, grouped into tools; strongest first.
std::vector<FoundTool> find_tools(const GrayImage& image, const contour::Circle& cell);

/// The same without a cell: long straight edges anywhere, paired where they run alongside each other within a tenth of
/// the image. Each pair comes twice, once for each end it may have come in from; offsets count from the image's centre.
/// Strongest first, at most 16.
std::vector<FoundTool> find_tools(const GrayImage& image);

}  // namespace pellucida
