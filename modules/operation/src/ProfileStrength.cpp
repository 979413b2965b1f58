#include "pellucida/operation/ProfileStrength.h"

namespace pellucida {

CellStrength strength_of(const CellProfile& profile) noexcept {
  CellStrength strength;
  strength.puncture_force_uN = profile.puncture_force_uN;
  strength.puncture_depth_um = profile.puncture_indentation_um;
  strength.max_stiffness_uN_per_um = 3.0 * profile.puncture_force_uN / profile.puncture_indentation_um;
  return strength;
}

}  // namespace pellucida
