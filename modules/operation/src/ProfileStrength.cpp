#include "pellucida/operation/ProfileStrength.h"

#include <algorithm>

namespace pellucida {

namespace {

/// A cell whose sizes were misread must not be pushed through: the limits rise to so many times its kind's at most.
constexpr double kHighest_ratio = 2.0;
/// The force grows with the third power of the depth at most.
constexpr double kSteepestPower = 3.0;

CellStrength strength(double force_uN, double depth_um) noexcept {
  CellStrength strength;
  strength.puncture_force_uN = force_uN;
  strength.puncture_depth_um = depth_um;
  strength.max_stiffness_uN_per_um = kSteepestPower * force_uN / depth_um;
  return strength;
}

}  // namespace

CellStrength strength_of(const CellProfile& profile) noexcept {
  return strength(profile.puncture_force_uN, profile.puncture_indentation_um);
}

CellStrength strength_of(const CellProfile& profile, const Measurement& seen) noexcept {
  if (!(seen.expected_puncture_uN > 0.0) || !(seen.expected_puncture_um > 0.0)) return strength_of(profile);
  return strength(std::min(seen.expected_puncture_uN, kHighest_ratio * profile.puncture_force_uN),
                  std::min(seen.expected_puncture_um, kHighest_ratio * profile.puncture_indentation_um));
}

}  // namespace pellucida
