#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pellucida {

/// All that describes one virtual experiment. The members are the keys of a scenario file, grouped as in the JSON; a
/// key left out has the default written here, an unknown key is an error. Angles in degrees, 0 = +x, positive towards
/// +y (down).
struct Scenario {
  std::string name;         ///< the shipped name or the file, as the user wrote it
  std::string description;  ///< one line for lists

  struct Image {
    int width_px = 728;            ///< 64..4096
    int height_px = 486;           ///< 64..4096
    double pixel_size_um = 0.825;  ///< 0.05..5
    int bit_depth = 8;             ///< 8 or 16
    double frame_rate_hz = 30.0;   ///< 1..1000
    double duration_s = 0.0;       ///< 0..3600; 0: until the needle's motion has ended
  } image;

  struct Cell {
    std::string reference = "mouse-oocyte";  ///< "mouse-oocyte" or "mouse-embryo"
    double center_x_um = 270.0;              ///< rest centre of the cell
    double center_y_um = 200.0;
    double size_scale = 1.0;            ///< 0.3..3: all lengths of the specimen; forces go with its square
    double perivitelline_gap_um = 0.0;  ///< 0..8: between zona and ooplasm; 0: none is seen
  } cell;

  struct Tools {
    int configuration = 1;              ///< 1: needle opposite the holder; 2: 45 degrees off; 3: 90 degrees off; 4: as
                                        ///< 1, 10 um beside the holder's axis (times `cell.size_scale`)
    double holder_angle_deg = 180.0;    ///< from the cell's centre to the holder; turns the whole scene
    bool mirrored = false;              ///< the needle on the other side of the holder's axis (configurations 2 to 4)
    double needle_tip_radius_um = 1.5;  ///< 0.5..3
    double needle_taper_deg = 3.0;      ///< 0.5..6: half-angle of its cone at the tip
    double needle_shaft_radius_um = 6.0;  ///< 1..12: what the cone widens to
  } tools;

  struct Motion {
    double gap_um = 12.0;                      ///< 0..300: tip to membrane at the start
    double approach_speed_um_per_s = 24.0;     ///< 1..500
    double indentation_um = 44.0;              ///< 0..200: how far the tip goes beyond the first touch
    double indentation_speed_um_per_s = 12.0;  ///< 1..500
    double hold_s = 0.8;                       ///< 0..600
    double retraction_speed_um_per_s = 0.0;    ///< 0..500; 0: it stays
    double smoothing_s = 0.3;                  ///< 0..5: time over which a speed changes
  } motion;

  struct Puncture {
    bool enabled = false;
    double indentation_um = 44.0;  ///< > 0: depth at which the membrane gives way
    double residual_um = 2.0;      ///< 0..20: depth the membrane keeps about the needle
    double relaxation_s = 0.06;    ///< 0.001..10: time constant of its return
    double spread_ratio = 0.0;     ///< 0..0.5: a cell bears this part less at most; the seed draws which
  } puncture;

  struct Optics {
    double background_ratio = 0.58;  ///< 0.1..0.9 of full scale
    double contrast = 1.0;           ///< 0.1..2: of edges and texture
    double halo = 1.0;               ///< 0..2: bright fringes beside dark edges
    double relief = 1.0;             ///< 0..2: one-sided shading, as of modulation contrast
    double granularity = 1.0;        ///< 0..3: of the ooplasm
    double gradient_ratio = 0.08;    ///< 0..0.6: illumination from one side to the other
    double gradient_angle_deg = 30.0;
    double vignette_ratio = 0.06;         ///< 0..0.6: loss in the corners
    double defocus_um = 0.0;              ///< 0..10: Gaussian blur of the whole image
    double needle_defocus_um = 0.4;       ///< 0..10: further blur of the needle
    double full_well_electrons = 9000.0;  ///< 100..1e6: shot noise
    double read_noise_electrons = 12.0;   ///< 0..1000
    bool noise = true;                    ///< false: a clean image
  } optics;

  struct Drift {              ///< cell, holder and needle together, as a stage or a camera moves
    double x_um_per_s = 0.0;  ///< -50..50
    double y_um_per_s = 0.0;
    double rotation_deg_per_s = 0.0;  ///< -90..90: about the image's centre, +x towards +y
    double jump_x_px = 0.0;           ///< -200..200: a knock moves all of it so far at once, the next one back
    double jump_y_px = 0.0;
    double jump_period_s = 0.7;  ///< 0.02..600: from knock to knock
  } drift;

  struct Lamp {
    double step_time_s = 1.0;    ///< 0..3600: when the light changes
    double step_ratio = 1.0;     ///< 0.2..1.6: the light after it, relative to before
    double flicker_ratio = 0.0;  ///< 0..0.3: amplitude of a slow sine
    double flicker_hz = 1.0;     ///< 0.01..100
  } lamp;

  struct Debris {
    int count = 5;                         ///< 0..500 particles that lie on the glass
    double max_radius_um = 2.5;            ///< 0.5..10: of these and of the passing ones
    int touching_count = 0;                ///< 0..60 particles that stick to the outer membrane and move with it
    double touching_radius_um = 2.5;       ///< 0.5..10
    int passing_count = 0;                 ///< 0..60 particles that float across the picture
    double passing_speed_um_per_s = 60.0;  ///< 0..500
  } debris;

  struct Bystander {            ///< what else lies in the dish and looks like a cell
    double cell_radius_um = 0;  ///< 0..150: outer radius of a second cell, untouched; 0: none
    double cell_x_um = 480.0;
    double cell_y_um = 60.0;
    double bubble_radius_um = 0;  ///< 0..150: of an air bubble; 0: none
    double bubble_x_um = 100.0;
    double bubble_y_um = 60.0;
  } bystander;

  std::uint64_t seed = 1;
};

/// Reads a scenario: a name in `resources/scenarios` or a JSON file.
/// Throws InputError (no such scenario; not JSON), UsageError (unknown key; wrong type; value outside its range: names
/// key, value and range).
Scenario load_scenario(std::string_view name_or_file);

/// The same from JSON text; `name` is used in messages.
Scenario parse_scenario(std::string_view json_text, std::string_view name);

/// Checks ranges and what belongs together. Throws UsageError.
void validate(const Scenario& scenario);

/// Names of the shipped scenarios.
std::vector<std::string> scenario_names();

}  // namespace pellucida
