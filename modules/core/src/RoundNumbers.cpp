#include "pellucida/core/RoundNumbers.h"

#include <cmath>
#include <initializer_list>

namespace pellucida {
namespace {

// Lets 5.0000001 count as 5.
constexpr double kSlack = 1.0 + 1e-9;
constexpr double kTickCount = 5.0;

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

std::vector<double> round_ticks(double low, double high, TickEnds ends) {
  const double step = nice_ceiling((high - low) / kTickCount, 0.0);
  const bool inside = ends == TickEnds::kInside;
  const double first = inside ? std::ceil(low / step - 1e-9) : std::floor(low / step + 1e-9);
  const double last = inside ? std::floor(high / step + 1e-9) : std::ceil(high / step - 1e-9);
  std::vector<double> ticks;
  for (double k = first; k <= last; k += 1.0) ticks.push_back(k * step);
  return ticks;
}

}  // namespace pellucida
