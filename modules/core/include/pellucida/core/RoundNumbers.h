#pragma once
#include <vector>

namespace pellucida {

/// The least of 1, 2, 5 times a power of ten that is not below `value`; `floor` for what is not above it.
double nice_ceiling(double value, double floor) noexcept;

/// The greatest of 1, 2, 5 times a power of ten that is not above `value`, > 0.
double nice_floor(double value) noexcept;

/// Where the ticks of an axis end: at the last round numbers within the range, or at the first ones that enclose it.
enum class TickEnds { kInside, kOutside };

/// About five round numbers from `low` to `high`, `low` < `high`, ascending.
std::vector<double> round_ticks(double low, double high, TickEnds ends);

}  // namespace pellucida
