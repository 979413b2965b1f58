#include "pellucida/visualization/Scaling.h"

#include <cmath>
#include <initializer_list>

namespace pellucida {
namespace {
// Lets 5.0000001 count as 5.
constexpr double kSlack = 1.0 + 1e-9;
}  // namespace

double nice_ceiling(double value, double floor) noexcept {
  if (!(value > floor)) return floor;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * decade * kSlack) return step * decade;
  }
  return 10.0 * decade;
}

double nice_floor(double value) noexcept {
  const double decade = std::pow(10.0, std::floor(std::log10(value * kSlack)));
  for (const double step : {5.0, 2.0}) {
    if (value * kSlack >= step * decade) return step * decade;
  }
  return decade;
}

double NiceRange::update(double maximum) noexcept {
  const double wanted = nice_ceiling(maximum, floor_);
  if (wanted > upper_) {
    upper_ = wanted;
    small_count_ = 0;
  } else if (maximum < 0.4 * upper_ && wanted < upper_) {
    if (++small_count_ > kPatience) {
      upper_ = wanted;
      small_count_ = 0;
    }
  } else {
    small_count_ = 0;
  }
  return upper_;
}

}  // namespace pellucida
