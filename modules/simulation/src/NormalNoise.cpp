#include "pellucida/simulation/NormalNoise.h"

#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

std::uint64_t mixed(std::uint64_t& state) noexcept {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

std::uint64_t next(std::array<std::uint64_t, 4>& s) noexcept {
  auto turn = [](std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); };
  const std::uint64_t result = turn(s[0] + s[3], 23) + s[0], t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = turn(s[3], 45);
  return result;
}

}  // namespace

NormalNoise::NormalNoise(std::uint64_t seed) noexcept {
  for (auto& word : state_) word = mixed(seed);
}

double NormalNoise::one() noexcept {
  if (spare_known_) {
    spare_known_ = false;
    return spare_;
  }
  // 53 bits, never 0.
  const double u = (static_cast<double>(next(state_) >> 11) + 0.5) * 0x1.0p-53;
  const double angle = 2 * std::numbers::pi * static_cast<double>(next(state_) >> 11) * 0x1.0p-53;
  const double radius = std::sqrt(-2 * std::log(u));
  spare_ = radius * std::sin(angle);
  spare_known_ = true;
  return radius * std::cos(angle);
}

PlainVector3 NormalNoise::three() noexcept {
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}

}  // namespace pellucida
