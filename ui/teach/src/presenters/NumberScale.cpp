#include "presenters/NumberScale.h"

#include <algorithm>
#include <cmath>

#include "pellucida/core/Html.h"

namespace pellucida {
double NumberScale::value_at(double place) const noexcept {
  const double part = std::clamp(place, 0.0, 1.0);
  const double value = is_log ? low * std::pow(high / low, part) : low + part * (high - low);
  return std::clamp(is_whole ? std::round(value) : value, low, high);
}

double NumberScale::place_of(double value) const noexcept {
  const double held = std::clamp(value, low, high);
  return is_log ? std::log(held / low) / std::log(high / low) : (held - low) / (high - low);
}

std::string three_digits(double value) {
  return fixed_number(value, std::max(0, decimals_of(value) - (value >= 10.0 ? 1 : 0)));
}

std::string duration_text(double time_us) {
  if (time_us < 999.5) return three_digits(time_us) + " µs";
  return three_digits(1e-3 * time_us) + " ms";
}

std::string short_number(double value) {
  return fixed_number(value, std::min(decimals_of(value), 3));
}

}  // namespace pellucida
