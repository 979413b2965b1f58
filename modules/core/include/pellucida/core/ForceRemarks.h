#pragma once
#include <limits>
#include <string>

namespace pellucida {

/// What a person should know beside a frame's force: why there is none, what speaks against it, what others say.
struct ForceRemarks {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::string reason;   ///< one line: why no force was measured; empty where there is one, or nothing to measure
  std::string warning;  ///< one line: why the force should be doubted; empty for no reason

  /// The same push by other models, uN; the force and its interval never depend on them. The point-load formula takes
  /// the zona for a planar, clamped membrane, so it differs by tens of per cent as a rule.
  double point_load_uN = kNone;
  double table_uN = kNone;  ///< the finite-element table of this kind of cell, within its depths and angles

  /// The scale in use: this cell's stiffness over its kind's, log-normal with that sigma.
  double scale_ratio = kNone;
  double scale_sigma_ratio = kNone;
  bool has_own_scale = false;  ///< measured on this cell
};

}  // namespace pellucida
