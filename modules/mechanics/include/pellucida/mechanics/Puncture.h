#pragma once

namespace pellucida {

/// A membrane that gave way.
struct Puncture {
  double time_s = 0.0;         ///< of the first frame that shows it
  double peak_force_uN = 0.0;  ///< largest force before
  double depth_um = 0.0;       ///< the deepest indentation before, with the force above
  double work_uN_um = 0.0;     ///< of the needle on the cell since the contact: integral of F dd, 1 uN um = 1e-12 J
};

}  // namespace pellucida
