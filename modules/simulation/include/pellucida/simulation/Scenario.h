#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

class FieldList;  // core/FieldTable.h

/// The look of a scenario that names none: drawn lines of bright field, by the keys in `optics`. All others are
/// resources of the module microscopy, by their name or file.
inline constexpr std::string_view kDrawing = "drawing";

/// All that describes one virtual experiment. The members are the keys of a scenario file, grouped as in the JSON; a
/// key left out has the default written here, an unknown key is an error. Angles in degrees, 0 = +x, positive towards
/// +y (down). Meaning, unit and range of each: docs/scenarios.md.
struct Scenario {
  std::string name;  ///< the shipped name or the file, as the user wrote it; no key
  std::string description;
  std::string look = std::string(kDrawing);

  struct Image {
    int width_px = 728;
    int height_px = 486;
    double pixel_size_um = 0.825;
    int bit_depth = 8;
    double frame_rate_hz = 30.0;
    double duration_s = 0.0;
  } image;

  struct Cell {
    std::string reference = "mouse-oocyte";
    double center_x_um = 270.0;
    double center_y_um = 200.0;
    double size_scale = 1.0;
    double stiffness_ratio = 1.0;
    double perivitelline_gap_um = 0.0;
    bool in_view = true;
  } cell;

  struct Tools {
    int configuration = 1;

    double holder_angle_deg = 180.0;
    bool mirrored = false;
    double needle_tip_radius_um = 0.0;
    double needle_taper_deg = 3.0;
    double needle_shaft_radius_um = 6.0;
  } tools;

  struct Motion {
    double gap_um = 12.0;
    double approach_speed_um_per_s = 24.0;
    double indentation_um = 44.0;
    double indentation_speed_um_per_s = 12.0;
    double hold_s = 0.8;
    double retraction_speed_um_per_s = 0.0;
    double smoothing_s = 0.3;
    double out_of_plane_um = 0.0;
    double out_of_plane_time_s = 1.0;
  } motion;

  struct Puncture {
    bool enabled = false;
    double indentation_um = 44.0;
    double residual_um = 2.0;
    double relaxation_s = 0.06;
    double spread_ratio = 0.0;
  } puncture;

  struct Optics {
    double background_ratio = 0.58;
    double contrast = 1.0;
    double halo = 1.0;
    double relief = 1.0;
    double granularity = 1.0;
    double gradient_ratio = 0.08;
    double gradient_angle_deg = 30.0;
    double vignette_ratio = 0.06;
    double defocus_um = 0.0;
    double needle_defocus_um = 0.4;
    double full_well_electrons = 9000.0;
    double read_noise_electrons = 12.0;
    bool noise = true;
  } optics;

  struct Drift {
    double x_um_per_s = 0.0;
    double y_um_per_s = 0.0;
    double rotation_deg_per_s = 0.0;
    double jump_x_px = 0.0;
    double jump_y_px = 0.0;
    double jump_period_s = 0.7;
  } drift;

  struct Lamp {
    double step_time_s = 1.0;
    double step_ratio = 1.0;
    double flicker_ratio = 0.0;
    double flicker_hz = 1.0;
  } lamp;

  struct Debris {
    int count = 5;
    double max_radius_um = 2.5;
    int touching_count = 0;
    double touching_radius_um = 2.5;
    int passing_count = 0;
    double passing_speed_um_per_s = 60.0;
  } debris;

  struct Bystander {
    double cell_radius_um = 0;
    double cell_x_um = 480.0;
    double cell_y_um = 60.0;
    double bubble_radius_um = 0;
    double bubble_x_um = 100.0;
    double bubble_y_um = 60.0;
  } bystander;

  std::uint64_t seed = 1;
};

/// Reads a scenario: a name in `resources/scenarios` or a JSON file. Keys may follow that replace those of the file:
/// `injection,cell.stiffness_ratio=2`; they become part of its name. Throws InputError (no such scenario; not JSON),
/// UsageError (unknown key; wrong type; value outside its range: names key, value and range).
Scenario load_scenario(std::string_view name_or_file);

/// The same from JSON text; `name` is used in messages.
Scenario parse_scenario(std::string_view json_text, std::string_view name);

/// The keys of a scenario file, with meaning, unit and range; docs/scenarios.md is printed from them.
FieldList fields_of(Scenario& scenario);

/// Checks ranges and what belongs together. Throws UsageError.
void validate(const Scenario& scenario);

/// Names of the shipped scenarios.
std::vector<std::string> scenario_names();

}  // namespace pellucida
