#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/membrane/Relaxation.h"

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// Constants of the membrane's mass-spring-damper model in one node region, as ratios: what multiplies E h and D.
struct RegionConstants {
  double k2_ratio = 0.0;     ///< K2 / (E h), > 0
  double k1_over_k2 = 0.0;   ///< K1 / K2; no less than -1/(3 e_max^2), or connectors turn soft
  double hinge_ratio = 0.0;  ///< g: hinge rigidity / D, > 0
};

/// The error of the model against a reference curve, as found when the profile was made.
struct ProfileError {
  int configuration = 0;  ///< see `setup_for_configuration`
  std::string reference;
  double largest_ratio = 0.0;
  double largest_of_peak_ratio = 0.0;
  double from_um = 0.0;
  double to_um = 0.0;
};

/// A curve that the constants were fitted to.
struct ProfileReference {
  int configuration = 0;
  double holder_angle_deg = 0.0;
  double offset_um = 0.0;
  int node_count = 0;
  double to_um = 0.0;
};

/// The highest powers in a `GeometryTerm`.
inline constexpr int kHighestSizePower = 3, kHighestDepthPower = 6;

/// One term of the springs' correction, see `geometry_factor`: powers of the logarithms of thickness, tip and holder
/// over the profile's (each over the radius), 0 to 3, and of the depth over the radius, 0 to 6.
struct GeometryTerm {
  int thickness = 0;
  int tip = 0;
  int holder = 0;
  int depth = 0;
  double coefficient = 0.0;
};

/// The geometries that those terms were fitted to, over the cell's radius, and what they leave.
struct GeometryRange {
  double thickness_from_ratio = 0.0, thickness_to_ratio = 0.0;
  double tip_from_ratio = 0.0, tip_to_ratio = 0.0;
  double holder_from_ratio = 0.0, holder_to_ratio = 0.0;
  double depth_to_ratio = 0.0;
  int cell_count = 0;
  double spread_ratio = 0.0;           ///< RMS difference of ln force on cells left out of the fit
  double pressure_spread_ratio = 0.0;  ///< of ln pressure; 0: not fitted
  /// What the shipped solid's force (`IndentedSolid`) is at the profile's effective modulus, over modulus and outer
  /// radius squared; 0: no solid, the springs' force with its terms everywhere.
  double solid_force_ratio = 0.0;
};

/// Everything that turns a shape into a force for one kind of cell; no such number is hidden in code. Loaded from
/// JSON. Meaning, unit and range of each number: docs/profiles.md.
struct CellProfile {
  std::string name;
  std::string description;
  std::vector<std::array<std::string, 2>> sources;  ///< (what, where it comes from)

  // Geometry at rest.
  double mid_radius_um = 0.0;
  double thickness_um = 0.0;
  double inner_radius_um = 0.0;

  // Material. The two moduli do not agree (docs/method.md, 3.7): the table's is kept for the record, the effective one
  // is used.
  double young_modulus_kPa = 0.0;
  double effective_young_modulus_kPa = 0.0;
  double force_scale_relative_sigma = 0.0;  ///< of the kind's mean
  double kind_spread_ratio = 0.46;          ///< how single cells of the kind differ about that
  double poisson_ratio = 0.5;
  double puncture_force_uN = 0.0;
  double puncture_indentation_um = 0.0;

  // Contact. Radii on the outer surface, from the tool's axis. Bond densities as ratios to the modulus, so that the
  // modulus is the only force scale.
  double tip_radius_um = 0.0;
  double tip_bond_per_um = 0.0;
  double holder_ring_um = 0.0;
  double holder_half_width_um = 0.0;
  double holder_bond_per_um = 0.0;

  // Mass-spring-damper constants by region, and the angles (from needle, from holder) where the regions end.
  RegionConstants tip, body, holder;
  double tip_angle_rad = 0.0;
  double holder_angle_rad = 0.0;
  double volume_stiffness_ratio = 0.0;
  double damping_uN_s_per_um = 0.0;  ///< b of eq. (1); the quasi-static solution doesn't use it
  double node_mass_kg = 0.0;         ///< m of eq. (2); likewise

  // The mesh the constants hold for.
  int mesh_frequency = 0;
  double mesh_grading = 1.0;

  std::vector<ProfileReference> references;  ///< empty if the profile's author did not record them
  std::vector<ProfileError> errors;

  /// Cells of another thickness, under other tools; empty: not identified, the force is the springs'.
  std::vector<GeometryTerm> geometry_terms;
  std::vector<GeometryTerm> geometry_pressure_terms;  ///< of the pressure; empty: it has the force's factor
  GeometryRange geometry_range;

  /// How the force falls while the needle rests; empty: unknown, and taken as no decay. The effective modulus is that
  /// of the push it was measured in, of `relaxation_anchor_ramp_s` from rest (0: a sudden one), during which the arms
  /// were already relaxing: a sudden push takes `relaxation_elastic_ratio` >= 1 times the force. 1 without arms.
  std::vector<RelaxationArm> relaxation_arms;
  double relaxation_elastic_ratio = 1.0;
  double relaxation_anchor_ramp_s = 0.0;

  /// E h at the effective modulus, uN/um.
  double membrane_stiffness_uN_per_um() const noexcept { return 1e-3 * effective_young_modulus_kPa * thickness_um; }
};

/// A shipped profile by name, or one in a file (its path). Throws UsageError that names the known profiles when there
/// is neither, InputError (file and key) when the file is damaged.
CellProfile load_profile(std::string_view name_or_file);

/// Reads a profile file. Throws InputError with file and key.
CellProfile read_profile(const std::filesystem::path& file);

/// Reads the text of a profile file, as `to_json` writes it; `where` begins the text of an InputError.
CellProfile parse_profile(std::string_view text, const std::string& where);

/// The keys of a profile file, with meaning, unit and range; docs/profiles.md is printed from them. Those of the
/// relaxation belong to a profile with arms only.
FieldList fields_of(CellProfile& profile);
FieldList relaxation_fields_of(CellProfile& profile);

/// Those of a profile with geometry terms.
FieldList fields_of(GeometryRange& range);

/// The keys of one entry of its lists.
FieldList fields_of(GeometryTerm& term);
FieldList fields_of(ProfileReference& reference);
FieldList fields_of(ProfileError& error);
FieldList fields_of(RelaxationArm& arm);

/// The profile as the JSON text of its file (two spaces of indent).
std::string to_json(const CellProfile& profile);

}  // namespace pellucida
