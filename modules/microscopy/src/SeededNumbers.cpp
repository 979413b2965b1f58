#include "pellucida/microscopy/SeededNumbers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucida {

double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

double normal(std::mt19937_64& engine) {
  const double u = std::max(uniform(engine), 1e-300), v = uniform(engine);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

NoiseBank::NoiseBank(std::uint64_t seed) : numbers_((1 << 20) + 8192), seed_(mix(seed ^ 0x6e6f697365ULL)) {
  std::mt19937_64 engine(seed_);
  for (std::size_t i = 0; i + 1 < numbers_.size(); i += 2) {
    // Box and Muller's pair.
    const double radius = std::sqrt(-2 * std::log(std::max(uniform(engine), 1e-300))),
                 angle = 2 * std::numbers::pi * uniform(engine);
    numbers_[i] = static_cast<float>(radius * std::cos(angle));
    numbers_[i + 1] = static_cast<float>(radius * std::sin(angle));
  }
}

const float* NoiseBank::row(long frame, int row) const noexcept {
  const std::uint64_t place =
      mix(seed_ ^ mix((static_cast<std::uint64_t>(frame) << 20) ^ static_cast<std::uint64_t>(row)));
  return numbers_.data() + (place & ((1 << 20) - 1));
}

}  // namespace pellucida
