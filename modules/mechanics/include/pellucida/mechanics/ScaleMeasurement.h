#pragma once
#include <string>
#include <vector>

#include "pellucida/membrane/PalpationUpdate.h"

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// How a cell's scale was measured.
enum class ScaleWay { kForce, kStiffness, kFibre, kAspiration };
/// "force", "stiffness", "fibre", "aspiration".
std::string to_string(ScaleWay way);

/// One measurement of a cell's own scale, with what it was measured with: a push of known force or stiffness, a push
/// through a fibre or calibrated pipette whose deflection was read, or the tongue that a known suction draws into the
/// holding pipette. A number of 0 was not given. Meaning, unit and range of each: `fields_of`, docs/file-format.md.
struct ScaleMeasurement {
  double known_force_uN = 0.0;
  double known_stiffness_uN_per_um = 0.0;
  double fibre_stiffness_uN_per_um = 0.0;
  double fibre_deflection_um = 0.0;
  double fibre_deflection_sigma_um = 0.3;
  double at_indentation_um = 0.0;
  double at_indentation_sigma_um = 0.2;
  double known_force_sigma_percent = 5.0;

  double suction_kPa = 0.0;
  double suction_sigma_percent = 3.0;
  double tongue_um = 0.0;
  double tongue_sigma_um = 0.4;
  double mouth_radius_um = 0.0;
  double mouth_radius_sigma_um = 0.3;
  double zona_thickness_um = 0.0;
  double zona_thickness_sigma_um = 0.4;

  // What finite elements make of an aspiration (identification/Aspiration.h).
  double modulus_kPa = 0.0;
  double modulus_sigma_percent = 0.0;
  double modulus_of_profile_ratio = 0.0;

  double since_s = 0.0;  ///< session time from which on it counts; 0: from the beginning
};
FieldList fields_of(ScaleMeasurement& measurement);

/// The measurements in numbers given together, one for each way, in the order of `ScaleWay`. Throws UsageError when
/// numbers contradict each other, or one is missing.
std::vector<ScaleMeasurement> separated(const ScaleMeasurement& given);

/// Of a measurement by itself. Throws as `separated`, and for more or less than one way.
ScaleWay way_of(const ScaleMeasurement& measurement);

/// "a push of 0.700 uN at 5.0 um, +- 5 %"; "a tongue of 12.0 um under 2.00 kPa: 35.1 kPa, +- 14 %"
std::string describe(const ScaleMeasurement& measurement);

/// The push of a measurement by force, stiffness or fibre. A fibre's force is its stiffness times its deflection, their
/// relative errors combined.
Palpation push_of(const ScaleMeasurement& measurement);

/// A cell's scale from any number of measurements, by Bayes' rule on three unknowns, each normal about 0: ln s of the
/// cell's stiffness over the profile's (`before`), the error g of the geometry in ln force, and that of the model, m.
/// Pushes measure s + g + m, moduli s. The order does not matter.
class ScaleEstimate {
 public:
  ScaleEstimate(const CellScale& before, double geometry_sigma, double model_sigma);

  /// A push: the known value over the model's, and the variance of its logarithm without geometry and model.
  void add_push(double ratio, double variance);
  /// A modulus over the profile's.
  void add_modulus(double ratio, double variance);

  /// Of s, or after a push of s + g: what forces of this cell under this needle are multiplied by.
  CellScale result() const;

 private:
  double information_[6];  // of (s, g, m), lower triangle
  double vector_[3];
  bool has_push_ = false;
};

}  // namespace pellucida
