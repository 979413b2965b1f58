#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// What a microscope makes of a scene: its contrast, the optical properties of cell and tools, and its camera. The
/// members are the keys of a look file, grouped as in the JSON; a key left out has the default written here, an unknown
/// key is an error. Indices are differences from the medium's. Meaning, unit and range of each: docs/looks.md.
struct Look {
  std::string name;  ///< the shipped name or the file, as the user wrote it; no key
  std::string description;

  struct Contrast {
    std::string kind = "bright-field";
    double strength = 1.0;
    bool inverted = false;
    double defocus_um = 5.0;
    double shear_angle_deg = 45.0;
    double bias_deg = 60.0;
    double shading_ratio = 0.0;
    double halo_um = 6.0;
    double point_spread_um = 0.5;
    double numerical_aperture = 0.4;
  } contrast;

  struct Cell {
    double zona_index = 0.015;
    double zona_softness_um = 0.0;
    double ooplasm_index = 0.03;
    double zona_absorption_per_mm = 0.0;
    double ooplasm_absorption_per_mm = 2.0;
    double grain_ratio = 1.0;
    double lipid_ratio = 0.0;
    double nucleus_radius_um = 0.0;
    double polar_body_radius_um = 0.0;
    double polar_body_angle_deg = 60.0;
    int cumulus_count = 0;
    double cumulus_radius_um = 5.0;
  } cell;

  struct Needle {
    std::string end = "closed";
    double lumen_ratio = 0.6;
    double liquid_index = 0.0;
    double bevel_deg = 35.0;
    double spike_um = 0.0;
    double index = 0.14;
  } needle;

  struct Holder {
    bool in_view = true;
    double wall_ratio = 0.45;
    double bend_per_mm = 0.0;
    double index = 0.14;
  } holder;

  struct Camera {
    double level_ratio = 0.55;
    double gradient_ratio = 0.06;
    double gradient_angle_deg = 30.0;
    double vignette_ratio = 0.08;
    int dust_count = 3;
    double dust_radius_px = 4.0;
    double full_well_electrons = 9000.0;
    double read_noise_electrons = 15.0;
    double fixed_pattern_ratio = 0.003;
    double gamma = 1.0;
    double exposure_step_ratio = 0.0;
    double exposure_period_s = 1.0;
    double sharpening_ratio = 0.0;
    bool interlaced = false;
    int jpeg_quality = 0;
  } camera;
};

/// Reads a look: a name in `resources/looks` or a JSON file. Throws InputError (no such look; not JSON), UsageError
/// (unknown key; wrong type; value outside its range).
Look load_look(std::string_view name_or_file);

/// The same from JSON text; `name` is used in messages.
Look parse_look(std::string_view json_text, std::string_view name);

/// The keys of a look file, with meaning, unit and range; docs/looks.md is printed from them.
FieldList fields_of(Look& look);

/// Checks ranges and names. Throws UsageError.
void validate(const Look& look);

/// Names of the shipped looks.
std::vector<std::string> look_names();

}  // namespace pellucida
