#pragma once
#include <type_traits>

namespace pellucida {

/// What a kind of cell bears: where its membrane gives way under the needle, and what it may ask of the hand until
/// then. The defaults are a mouse oocyte (7.5 uN at 44 um, growing with the third power of depth).
struct CellStrength {
  double puncture_force_uN = 7.5;
  double puncture_depth_um = 44.0;  ///< indentation
  double max_stiffness_uN_per_um = 0.51;
  double max_damping_uN_s_per_um = 0.0;
};
static_assert(std::is_trivially_copyable_v<CellStrength>);

/// The limits of force and depth lie by this above the puncture of the cell's kind. The push gets slower from four
/// fifths of the force limit on, which is the puncture itself: a cell as strong as its kind is not slowed, one up to a
/// quarter stronger can be punctured, and no push goes further. The same quarter is between a device's largest force
/// and the default scale's at the puncture, so that the device has force left up to the limit.
inline constexpr double kPunctureMargin = 1.25;

}  // namespace pellucida
