#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace pellucida {

/// Cell and tools that a finite-element reference was computed for: NAME-geometry.json beside its tables.
struct ReferenceGeometry {
  double middle_radius_um = 0.0;      ///< of the zona's middle surface at rest
  double thickness_um = 0.0;          ///< of the zona
  double tip_radius_um = 0.0;         ///< of the patch on the outer surface where the needle bears
  double holder_ring_um = 0.0;        ///< mean radius of the ring on which the holder bears
  double holder_half_width_um = 0.0;  ///< and half that ring's width
  double young_modulus_kPa = 0.0;     ///< that the forces are for
  // Where a specimen is unlike the profile's cells.
  double aspect_ratio = 1.0;      ///< of a spheroid: its semi-axis along the needle over that across
  double holder_angle_deg = 0.0;  ///< between the needle's push and the direction to the holder, in configuration 1
  double offset_um = 0.0;         ///< of the needle's line from the centre, in configuration 1
  double suction_kPa = 0.0;       ///< in the holder's mouth
  double stiffening = 0.0;        ///< b in a wall of the energy mu/(2 b) (exp(b (I1 - 3)) - 1); 0: neo-Hookean

  double outer_radius_um() const noexcept { return middle_radius_um + 0.5 * thickness_um; }
  double inner_radius_um() const noexcept { return middle_radius_um - 0.5 * thickness_um; }
  /// From the centre to the outer surface, `angle_rad` off the needle's axis.
  double outer_radius_um(double angle_rad) const noexcept;
};

/// Folder and stem of a cell's tables.
struct ReferencePlace {
  std::filesystem::path folder;
  std::string name;

  /// `ending` "-geometry.json", "-1-force.csv" and the like.
  std::filesystem::path file(std::string_view ending) const { return folder / (name + std::string(ending)); }
};

/// `cell`: a shipped one by its name, or the path of others' tables without the ending (`films/specimen-7` for
/// `films/specimen-7-1-force.csv`).
ReferencePlace find_reference(std::string_view cell);

/// Reads it. Throws UsageError when there is no such cell, InputError (file and key) when the file is damaged.
ReferenceGeometry load_reference_geometry(std::string_view cell);

}  // namespace pellucida
