#pragma once
#include <Eigen/Core>

#include "HolderFinder.h"
#include "NeedleTracker.h"

namespace pellucida {

/// Tools face each other, or lie along each other, when their directions are as near as this (cosine).
inline constexpr double kAlongHolder = 0.9;
/// Of the cell's radius, beyond the centre: a needle does not lie with its tip further through the cell.
inline constexpr double kThrough_ratio = 0.9;

/// Whether a needle ends before it is so far, px, beyond the centre: none goes on through the whole cell.
bool is_before(const NeedleEstimate& needle, const Eigen::Vector2d& center, double most_px);

/// Whether a needle runs as the holder does, its tip within so many of the holder's half widths of its middle.
bool is_along(const HolderFit& holder, const NeedleEstimate& needle, const Eigen::Vector2d& center, double half_widths);

}  // namespace pellucida
