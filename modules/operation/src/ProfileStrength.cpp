#include "pellucida/operation/ProfileStrength.h"

#include <cmath>

namespace pellucida {

CellStrength strength_of(const CellProfile& profile, double scale_ratio) noexcept {
  CellStrength strength;
  strength.puncture_force_uN = profile.puncture_force_uN;
  strength.puncture_depth_um = profile.puncture_indentation_um / std::cbrt(scale_ratio);
  strength.max_stiffness_uN_per_um = 3.0 * strength.puncture_force_uN / strength.puncture_depth_um;
  return strength;
}

}  // namespace pellucida
