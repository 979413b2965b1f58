#include "EdgeProfile.h"

#include <cmath>

namespace pellucida {

EdgeProfile::EdgeProfile(const std::function<double(double)>& value, double band_um, double width_um,
                         bool dark_at_zero) {
  constexpr double kStep_um = 0.02;
  const double h = 1e-4, slope = dark_at_zero ? (value(h) - value(-h)) / (2 * h) : 0.0;
  const int half = static_cast<int>(std::ceil(band_um / kStep_um));
  table_.reserve(static_cast<std::size_t>(2 * half + 1));
  for (int i = -half; i <= half; ++i) {
    const double s = i * kStep_um;
    table_.push_back(static_cast<float>(value(s) - slope * s * gaussian(s, width_um)));
  }
  band_um_ = static_cast<float>(half * kStep_um);
  inverse_step_ = static_cast<float>(1 / kStep_um);
}

double gaussian(double x, double sigma) noexcept {
  return std::exp(-x * x / (2 * sigma * sigma));
}
double soft_step(double x, double width) noexcept {
  return 0.5 * std::erfc(-x / (width * std::sqrt(2.0)));
}

}  // namespace pellucida
