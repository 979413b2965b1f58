#pragma once
#include <array>
#include <cstdint>

#include "pellucida/core/PlainVector.h"

namespace pellucida {

/// Normal deviates, the same on every machine: xoshiro256++ (Blackman and Vigna, 2021) seeded by splitmix64, and Box
/// and Muller. Nothing allocates or throws.
class NormalNoise {
 public:
  explicit NormalNoise(std::uint64_t seed) noexcept;

  double one() noexcept;
  PlainVector3 three() noexcept;

 private:
  std::array<std::uint64_t, 4> state_{};
  bool spare_known_ = false;
  double spare_ = 0.0;
};

}  // namespace pellucida
