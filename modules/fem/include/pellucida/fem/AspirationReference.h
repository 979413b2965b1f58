#pragma once
#include <memory>
#include <vector>

#include "pellucida/fem/CurveOutcome.h"

namespace pellucida {

/// A spherical shell full of liquid, sucked into the round mouth of a pipette. Lengths in um.
struct AspiratedShell {
  double outer_radius_um = 52.5;  ///< of the shell's outer surface, at rest
  double thickness_um = 5.0;      ///< 0.01 to 0.95 of the outer radius
  double mouth_radius_um = 10.0;  ///< inner radius of the pipette's mouth; up to 0.6 of the outer radius
  double lip_width_um = 5.0;      ///< of the wall that the shell bears on; mouth and lip up to 0.9 of that radius
};

/// An equilibrium: the suction over Young's modulus, and how far the tongue's apex lies inside the plane of the mouth.
struct AspirationStep {
  double suction_ratio = 0.0;
  double tongue_um = 0.0;
};

struct AspirationCurve {
  CurveOutcome outcome = CurveOutcome::kComplete;
  std::vector<AspirationStep> steps;  ///< converged ones, the first without suction
};

/// The aspirated shell by finite elements: the solid of revolution of `SolidReference` (incompressible neo-Hookean,
/// nine-node elements) under a uniform suction on the surface within the mouth, bonded to the lip, full of liquid. No
/// slip, no friction, no prestress. The modulus is the only scale of pressure, so all is in terms of it. Thick shells
/// on narrow mouths meet the half-space formula. One thread at a time.
class AspirationReference {
 public:
  /// Throws UsageError, naming the number, when one is outside its range.
  explicit AspirationReference(const AspiratedShell& shell, double edge_length_ratio = 1.0);
  ~AspirationReference();

  /// The cap of the unloaded sphere within the mouth.
  double rest_tongue_um() const noexcept;

  /// Suction in steps until the tongue is `tongue_um` long, or `greatest_suction_ratio` is reached, or no equilibrium
  /// is found; the last step then is at that tongue, within 1e-4 of the mouth's radius. Throws UsageError unless the
  /// tongue is longer than at rest.
  AspirationCurve run(double tongue_um, double greatest_suction_ratio = 3.0);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The suction over the modulus at which a half-space forms a tongue of that length, measured from its flat surface,
/// Theret et al. (J. Biomech. Eng. 110, 1988), punch model: E = 3 Phi dP Rp / (2 pi L), Phi = 2.1.
double half_space_suction_ratio(double tongue_um, double mouth_radius_um) noexcept;

}  // namespace pellucida
