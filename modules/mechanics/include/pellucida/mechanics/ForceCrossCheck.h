#pragma once
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "pellucida/membrane/CellProfile.h"

namespace pellucida {

/// The force according to other models, beside the estimate, for analysts; the estimate never depends on them.
struct ForceCrossCheck {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  double point_load_uN = kNone;   ///< planar, clamped membrane under a point load, with the table's modulus
  double table_uN = kNone;        ///< finite-element table of this kind of cell
  double spread_percent = kNone;  ///< of the estimate and these: standard deviation over mean
};

/// The point-load formula of Sun et al. 2003 (as reused by the paper), uN:
///   F = 2 pi E h w^3 / (a^2 (1 - nu)) (3 - 4 z^2 + z^4 + 2 ln z^2) / ((1 - z^2)(1 - z^2 + ln z^2)^3),  z = c / a,
/// E in kPa, h the membrane's thickness, w the dimple's depth, a its radius, c the tip's. Planar, clamped at the mouth,
/// point load, no bending. Nothing unless 0 < c < 0.95 a and w > 0.
std::optional<double> point_load_force_uN(double young_modulus_kPa, double poisson_ratio, double thickness_um,
                                          double depth_um, double dimple_radius_um, double tip_radius_um) noexcept;

/// The finite-element force-indentation tables shipped for a kind of cell, `reference/NAME-{1,2,3}-force.csv` in the
/// resources. Between the holder's angles of the tables it is linear in the angle, and in the depth between their
/// rows; lengths scale with the cell's radius (a force with its square).
class ForceTables {
 public:
  /// Those of `cell`; none if none are shipped. Throws InputError when a table is damaged.
  explicit ForceTables(std::string_view cell);

  /// Nothing outside the tables. `size_ratio` > 0: the cell's radius over the table's.
  std::optional<double> force_uN(double depth_um, double holder_angle_rad, double size_ratio = 1.0) const noexcept;

 private:
  struct Table {
    double holder_angle_rad = 0.0;
    std::vector<double> depth_um, force_uN;
  };
  std::vector<Table> tables_;  // by rising angle
};

/// Standard deviation over mean, %, of `estimate_uN` and the models that give a force; nothing with fewer than two.
double spread_percent(double estimate_uN, const ForceCrossCheck& opinions) noexcept;

}  // namespace pellucida
