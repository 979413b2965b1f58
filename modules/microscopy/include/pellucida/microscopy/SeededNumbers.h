#pragma once
#include <cstdint>
#include <random>
#include <vector>

namespace pellucida {

/// Random numbers made by hand: the standard's distributions may differ between libraries, these bytes may not.
/// Uniform in 0..1, 1 excluded.
double uniform(std::mt19937_64& engine);
/// Standard normal.
double normal(std::mt19937_64& engine);
/// A seed of another stream: neighbouring values give unrelated ones.
std::uint64_t mix(std::uint64_t value);

/// A bank of standard normal numbers, drawn once; each frame reads it from another place.
class NoiseBank {
 public:
  explicit NoiseBank(std::uint64_t seed);
  /// `count` numbers for row `row` of frame `frame`; `count` at most 8192.
  const float* row(long frame, int row) const noexcept;

 private:
  std::vector<float> numbers_;
  std::uint64_t seed_;
};

}  // namespace pellucida
