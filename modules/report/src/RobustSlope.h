#pragma once
#include <cstddef>
#include <optional>
#include <vector>

namespace pellucida {

/// A slope with its 95 % interval.
struct RobustSlope {
  double value = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};

/// Half a normal number's 95 % interval, in standard deviations.
inline constexpr double kZ95 = 1.96;

/// Below this many points there is no slope.
inline constexpr std::size_t kFewestSlopePoints = 5;

/// Theil and Sen: the median of the slopes between all pairs of points, which a quarter of wild points does not move;
/// the interval by Sen (1968), from the ranks of those slopes. Nothing for fewer than `kFewestSlopePoints` points, or
/// where all x are the same. More than 400 points are thinned evenly.
std::optional<RobustSlope> robust_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace pellucida
