#include "FrameSampler.h"

#include <array>
#include <cmath>

namespace pellucida {

double noise_level(const FrameSampler& image) {
  // Second differences along rows kill slopes.
  constexpr int kRows = 40, kColumns = 56;
  std::array<float, kRows * kColumns> values;
  std::size_t count = 0;
  if (image.width < 3) return 1e-4;
  for (int k = 0; k < kRows && k < image.height; ++k) {
    const int y = static_cast<int>((static_cast<long>(k) * image.height) / std::min(kRows, image.height));
    const int columns = std::min(kColumns, image.width - 2);
    for (int l = 0; l < columns; ++l) {
      const int x = 1 + static_cast<int>((static_cast<long>(l) * (image.width - 2)) / columns);
      values[count++] = std::abs(image.at(x - 1, y) - 2.0F * image.at(x, y) + image.at(x + 1, y));
    }
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
  // Median of |second difference| of white noise: 0.6745 * sqrt(6) * sigma.
  return std::max(1e-4, double{*middle} / (0.6745 * std::sqrt(6.0)));
}

}  // namespace pellucida
