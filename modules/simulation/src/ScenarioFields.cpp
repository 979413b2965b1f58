#include "pellucida/core/FieldTable.h"
#include "pellucida/simulation/Scenario.h"

namespace pellucida {
namespace scenario_tables {

constexpr FieldRange kNone;  // of a text or a flag
constexpr FieldRange kPlace_um{-1e4, 1e4}, kDegrees{-360, 360};

constexpr Field<Scenario> kTop[] = {
    {"description", "", &Scenario::description, kNone, "one line for lists"},
    {"look", "", &Scenario::look, kNone,
     "contrast, tools and camera, a look's name or file ([looks](looks.md)); `drawing`: plain bright field, by "
     "`optics`"},
    {"seed", "", &Scenario::seed, {0}, "of everything random: the same seed, the same pictures"},
};

using Image = Scenario::Image;
constexpr Field<Image> kImage[] = {
    {"width_px", "px", &Image::width_px, {64, 4096}, "of the picture"},
    {"height_px", "px", &Image::height_px, {64, 4096}, "of the picture"},
    {"pixel_size_um", "um", &Image::pixel_size_um, {0.05, 5}, "edge of a pixel in the plane of the cell"},
    {"bit_depth", "bit", &Image::bit_depth, {8, 16}, "of a pixel: 8 or 16"},
    {"frame_rate_hz", "Hz", &Image::frame_rate_hz, {1, 1000}, "of the camera"},
    {"duration_s", "s", &Image::duration_s, {0, 3600}, "of the film; 0: until the needle's motion has ended"},
};

using Cell = Scenario::Cell;
constexpr Field<Cell> kCell[] = {
    {"reference", "", &Cell::reference, kNone,
     "the finite-element curves: `mouse-oocyte`, `mouse-embryo`, or others' tables by their path without the ending"},
    {"center_x_um", "um", &Cell::center_x_um, kPlace_um, "rest centre of the cell, to the right"},
    {"center_y_um", "um", &Cell::center_y_um, kPlace_um, "rest centre of the cell, down"},
    {"size_scale", "", &Cell::size_scale, {0.3, 3}, "factor on all lengths of the specimen; forces go with its square"},
    {"stiffness_ratio",
     "",
     &Cell::stiffness_ratio,
     {0.05, 20},
     "factor on all forces of the specimen and on its pressure; its shapes stay"},
    {"perivitelline_gap_um", "um", &Cell::perivitelline_gap_um, {0, 8}, "between zona and ooplasm; 0: none is seen"},
    {"in_view", "", &Cell::in_view, kNone, "false: tools, debris and bystanders alone"},
};

using Tools = Scenario::Tools;
constexpr Field<Tools> kTools[] = {
    {"configuration",
     "",
     &Tools::configuration,
     {1, 4},
     "1: needle opposite the holder; 2: 45 degrees off; 3: 90 degrees off; 4: as 1, 10 um beside the holder's axis "
     "(times `cell.size_scale`)"},
    {"holder_angle_deg", "degrees", &Tools::holder_angle_deg, kDegrees,
     "from the cell's centre to the holder; turns the whole scene"},
    {"mirrored", "", &Tools::mirrored, kNone, "the needle is on the other side of the holder's axis (2 to 4)"},
    {"needle_tip_radius_um", "um", &Tools::needle_tip_radius_um, {0, 20}, "as drawn; 0: the tip the forces are for"},
    {"needle_taper_deg", "degrees", &Tools::needle_taper_deg, {0.5, 6}, "half-angle of the needle's cone at the tip"},
    {"needle_shaft_radius_um",
     "um",
     &Tools::needle_shaft_radius_um,
     {1, 30},
     "what the cone widens to; no less than a tip's radius that is given, and a fifth more than the finite elements'"},
};

using Motion = Scenario::Motion;
constexpr Field<Motion> kMotion[] = {
    {"gap_um", "um", &Motion::gap_um, {0, 300}, "tip to membrane at the start"},
    {"approach_speed_um_per_s", "um/s", &Motion::approach_speed_um_per_s, {1, 500}, "until the first touch"},
    {"indentation_um", "um", &Motion::indentation_um, {0, 200}, "how far the tip goes beyond the first touch"},
    {"indentation_speed_um_per_s", "um/s", &Motion::indentation_speed_um_per_s, {1, 500}, "from there on"},
    {"hold_s", "s", &Motion::hold_s, {0, 600}, "rest at the deepest point"},
    {"retraction_speed_um_per_s", "um/s", &Motion::retraction_speed_um_per_s, {0, 500}, "back; 0: the needle stays"},
    {"smoothing_s", "s", &Motion::smoothing_s, {0, 5}, "time over which a speed changes"},
    {"out_of_plane_um", "um", &Motion::out_of_plane_um, {-60, 60}, "the needle also moves so far in depth"},
    {"out_of_plane_time_s", "s", &Motion::out_of_plane_time_s, {0, 3600}, "when that begins; it takes 0.3 s"},
};

using Puncture = Scenario::Puncture;
constexpr Field<Puncture> kPuncture[] = {
    {"enabled", "", &Puncture::enabled, kNone, "the membrane can give way"},
    {"indentation_um", "um", &Puncture::indentation_um, {0.5, 200}, "depth at which it gives way"},
    {"residual_um", "um", &Puncture::residual_um, {0, 20}, "depth that it keeps about the needle"},
    {"relaxation_s", "s", &Puncture::relaxation_s, {0.001, 10}, "time constant of its return"},
    {"spread_ratio", "", &Puncture::spread_ratio, {0, 0.5}, "a cell bears up to this part less; the seed draws which"},
};

using Optics = Scenario::Optics;
constexpr Field<Optics> kOptics[] = {
    {"background_ratio", "", &Optics::background_ratio, {0.1, 0.9}, "brightness of the background, of full scale"},
    {"contrast", "", &Optics::contrast, {0.1, 2}, "factor on edges and texture"},
    {"halo", "", &Optics::halo, {0, 2}, "factor on the bright fringes beside dark edges"},
    {"relief", "", &Optics::relief, {0, 2}, "factor on the one-sided shading, as of modulation contrast"},
    {"granularity", "", &Optics::granularity, {0, 3}, "factor on the texture of the ooplasm"},
    {"gradient_ratio", "", &Optics::gradient_ratio, {0, 0.6}, "change of the illumination from one side to the other"},
    {"gradient_angle_deg", "degrees", &Optics::gradient_angle_deg, kDegrees, "towards its bright side"},
    {"vignette_ratio", "", &Optics::vignette_ratio, {0, 0.6}, "loss of light in the corners"},
    {"defocus_um", "um", &Optics::defocus_um, {0, 10}, "Gaussian blur of the whole image"},
    {"needle_defocus_um", "um", &Optics::needle_defocus_um, {0, 10}, "further blur of the needle"},
    {"full_well_electrons",
     "electrons",
     &Optics::full_well_electrons,
     {100, 1e6},
     "at full scale: sets the shot noise"},
    {"read_noise_electrons", "electrons", &Optics::read_noise_electrons, {0, 1000}, "of the camera"},
    {"noise", "", &Optics::noise, kNone, "false: a clean image"},
};

using Drift = Scenario::Drift;
constexpr Field<Drift> kDrift[] = {
    {"x_um_per_s", "um/s", &Drift::x_um_per_s, {-50, 50}, "of cell, holder and needle together, to the right"},
    {"y_um_per_s", "um/s", &Drift::y_um_per_s, {-50, 50}, "the same, down"},
    {"rotation_deg_per_s",
     "degrees/s",
     &Drift::rotation_deg_per_s,
     {-90, 90},
     "about the image's centre, +x towards +y"},
    {"jump_x_px", "px", &Drift::jump_x_px, {-200, 200}, "a knock moves all of it so far at once, the next one back"},
    {"jump_y_px", "px", &Drift::jump_y_px, {-200, 200}, "the same, down"},
    {"jump_period_s", "s", &Drift::jump_period_s, {0.02, 600}, "from knock to knock"},
};

using Lamp = Scenario::Lamp;
constexpr Field<Lamp> kLamp[] = {
    {"step_time_s", "s", &Lamp::step_time_s, {0, 3600}, "when the light changes"},
    {"step_ratio", "", &Lamp::step_ratio, {0.2, 1.6}, "the light after it, relative to before"},
    {"flicker_ratio", "", &Lamp::flicker_ratio, {0, 0.3}, "amplitude of a slow sine"},
    {"flicker_hz", "Hz", &Lamp::flicker_hz, {0.01, 100}, "of that sine"},
};

using Debris = Scenario::Debris;
constexpr Field<Debris> kDebris[] = {
    {"count", "", &Debris::count, {0, 500}, "particles that lie on the glass"},
    {"max_radius_um", "um", &Debris::max_radius_um, {0.5, 10}, "of these and of the passing ones"},
    {"touching_count",
     "",
     &Debris::touching_count,
     {0, 60},
     "particles that stick to the outer membrane, move with it"},
    {"touching_radius_um", "um", &Debris::touching_radius_um, {0.5, 10}, "of those"},
    {"passing_count", "", &Debris::passing_count, {0, 60}, "particles that float across the picture"},
    {"passing_speed_um_per_s", "um/s", &Debris::passing_speed_um_per_s, {0, 500}, "of those"},
};

using Bystander = Scenario::Bystander;
constexpr Field<Bystander> kBystander[] = {
    {"cell_radius_um", "um", &Bystander::cell_radius_um, {0, 150}, "outer radius of a second, untouched cell; 0: none"},
    {"cell_x_um", "um", &Bystander::cell_x_um, kPlace_um, "its centre, to the right"},
    {"cell_y_um", "um", &Bystander::cell_y_um, kPlace_um, "its centre, down"},
    {"bubble_radius_um", "um", &Bystander::bubble_radius_um, {0, 150}, "of an air bubble; 0: none"},
    {"bubble_x_um", "um", &Bystander::bubble_x_um, kPlace_um, "its centre, to the right"},
    {"bubble_y_um", "um", &Bystander::bubble_y_um, kPlace_um, "its centre, down"},
};

}  // namespace scenario_tables

FieldList fields_of(Scenario& s) {
  using namespace scenario_tables;
  FieldList fields;
  fields.add("", kTop, s)
      .add("image", kImage, s.image)
      .add("cell", kCell, s.cell)
      .add("tools", kTools, s.tools)
      .add("motion", kMotion, s.motion)
      .add("puncture", kPuncture, s.puncture)
      .add("optics", kOptics, s.optics)
      .add("drift", kDrift, s.drift)
      .add("lamp", kLamp, s.lamp)
      .add("debris", kDebris, s.debris)
      .add("bystander", kBystander, s.bystander);
  return fields;
}

}  // namespace pellucida
