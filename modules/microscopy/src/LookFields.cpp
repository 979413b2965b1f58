#include "pellucida/core/FieldTable.h"
#include "pellucida/microscopy/Look.h"

namespace pellucida {
namespace look_tables {

constexpr FieldRange kNone;  // of a text or a flag
constexpr FieldRange kDegrees{-360, 360};

constexpr Field<Look> kTop[] = {{"description", "", &Look::description, kNone, "one line for lists"}};

using Contrast = Look::Contrast;
constexpr Field<Contrast> kContrast[] = {
    {"kind", "", &Contrast::kind, kNone, "`bright-field`, `hoffman`, `dic`, `phase` or `dark-field`"},
    {"strength", "", &Contrast::strength, {0.05, 5}, "factor on what the contrast makes of the optical path"},
    {"inverted", "", &Contrast::inverted, kNone, "phase: bodies brighter than the background, with a dark halo"},
    {"defocus_um",
     "um",
     &Contrast::defocus_um,
     {-40, 40},
     "bright field: of the objective; its sign orders dark and bright lines"},
    {"shear_angle_deg", "degrees", &Contrast::shear_angle_deg, kDegrees,
     "relief: where the light seems to come from; half a turn more swaps bright and dark"},
    {"bias_deg", "degrees", &Contrast::bias_deg, {5, 175}, "DIC: phase between the beams on the background"},
    {"shading_ratio",
     "",
     &Contrast::shading_ratio,
     {-0.8, 0.8},
     "Hoffman: change of the background along the shear, from side to side"},
    {"halo_um", "um", &Contrast::halo_um, {1, 60}, "phase: width of the halo"},
    {"point_spread_um", "um", &Contrast::point_spread_um, {0.1, 5}, "standard deviation of the point spread"},
    {"numerical_aperture",
     "",
     &Contrast::numerical_aperture,
     {0.05, 1},
     "light refracted beyond it is lost: thick glass and air have dark edges"},
};

using Cell = Look::Cell;
constexpr Field<Cell> kCell[] = {
    {"zona_index", "", &Cell::zona_index, {-0.05, 0.1}, "refractive index of the zona less the medium's"},
    {"zona_softness_um",
     "um",
     &Cell::zona_softness_um,
     {0, 6},
     "the zona's index fades over this width, half of it beyond the outer boundary"},
    {"ooplasm_index", "", &Cell::ooplasm_index, {-0.05, 0.1}, "the same of the ooplasm"},
    {"zona_absorption_per_mm", "1/mm", &Cell::zona_absorption_per_mm, {0, 60}, "light the zona absorbs on its way"},
    {"ooplasm_absorption_per_mm", "1/mm", &Cell::ooplasm_absorption_per_mm, {0, 60}, "the same of the ooplasm"},
    {"grain_ratio", "", &Cell::grain_ratio, {0, 5}, "factor on the ooplasm's granules; 0: clear"},
    {"lipid_ratio", "", &Cell::lipid_ratio, {0, 3}, "factor on the number of lipid droplets, as of pig and cow"},
    {"nucleus_radius_um", "um", &Cell::nucleus_radius_um, {0, 20}, "of a clear nucleus with a nucleolus; 0: none"},
    {"polar_body_radius_um",
     "um",
     &Cell::polar_body_radius_um,
     {0, 15},
     "of the polar body under the zona; 0: none is seen"},
    {"polar_body_angle_deg", "degrees", &Cell::polar_body_angle_deg, kDegrees, "its place, from the needle's side"},
    {"cumulus_count", "", &Cell::cumulus_count, {0, 200}, "cells that stick to the zona"},
    {"cumulus_radius_um", "um", &Cell::cumulus_radius_um, {1, 15}, "of these"},
};

using Needle = Look::Needle;
constexpr Field<Needle> kNeedle[] = {
    {"end", "", &Needle::end, kNone, "`closed` (round), `open` (cut straight) or `bevelled`"},
    {"lumen_ratio", "", &Needle::lumen_ratio, {0, 0.95}, "inner width of the glass, of its outer width; 0: solid"},
    {"liquid_index", "", &Needle::liquid_index, {-0.35, 0.2}, "index of what fills it less the medium's"},
    {"bevel_deg", "degrees", &Needle::bevel_deg, {15, 75}, "between the cut and the axis"},
    {"spike_um", "um", &Needle::spike_um, {0, 15}, "length of a spike at the tip of a bevelled needle; 0: none"},
    {"index", "", &Needle::index, {0.02, 0.3}, "of the glass less the medium's"},
};

using Holder = Look::Holder;
constexpr Field<Holder> kHolder[] = {
    {"in_view", "", &Holder::in_view, kNone, "false: nothing holds the cell in the picture"},
    {"wall_ratio", "", &Holder::wall_ratio, {0.08, 0.9}, "thickness of the wall, of the outer radius"},
    {"bend_per_mm", "1/mm", &Holder::bend_per_mm, {-10, 10}, "curvature of the tube behind its mouth; 0: straight"},
    {"index", "", &Holder::index, {0.02, 0.3}, "of the glass less the medium's"},
};

using Camera = Look::Camera;
constexpr Field<Camera> kCamera[] = {
    {"level_ratio", "", &Camera::level_ratio, {0.02, 0.95}, "brightness of the background, of full scale"},
    {"gradient_ratio", "", &Camera::gradient_ratio, {0, 0.8}, "change of the illumination from side to side"},
    {"gradient_angle_deg", "degrees", &Camera::gradient_angle_deg, kDegrees, "towards its bright side"},
    {"vignette_ratio", "", &Camera::vignette_ratio, {0, 0.8}, "loss of light in the corners"},
    {"dust_count", "", &Camera::dust_count, {0, 200}, "specks on the sensor, fixed in the picture"},
    {"dust_radius_px", "px", &Camera::dust_radius_px, {1, 40}, "of the largest"},
    {"full_well_electrons", "electrons", &Camera::full_well_electrons, {100, 1e6}, "at full scale: the shot noise"},
    {"read_noise_electrons", "electrons", &Camera::read_noise_electrons, {0, 2000}, "of the camera"},
    {"fixed_pattern_ratio", "", &Camera::fixed_pattern_ratio, {0, 0.1}, "spread of pixels and columns, of full scale"},
    {"gamma", "", &Camera::gamma, {0.3, 2}, "exponent from light to grey value; 0.45: video"},
    {"exposure_step_ratio",
     "",
     &Camera::exposure_step_ratio,
     {-0.5, 1},
     "an automatic exposure steps up so much and back again"},
    {"exposure_period_s", "s", &Camera::exposure_period_s, {0.05, 600}, "from step to step"},
    {"sharpening_ratio", "", &Camera::sharpening_ratio, {0, 3}, "unsharp masking in the camera: bright and dark seams"},
    {"interlaced", "", &Camera::interlaced, kNone, "every other row shows the frame drawn before"},
    {"jpeg_quality", "", &Camera::jpeg_quality, {0, 100}, "of a camera that sends JPEG (8 bit); 0: none"},
};

}  // namespace look_tables

FieldList fields_of(Look& look) {
  using namespace look_tables;
  FieldList fields;
  fields.add("", kTop, look)
      .add("contrast", kContrast, look.contrast)
      .add("cell", kCell, look.cell)
      .add("needle", kNeedle, look.needle)
      .add("holder", kHolder, look.holder)
      .add("camera", kCamera, look.camera);
  return fields;
}

}  // namespace pellucida
