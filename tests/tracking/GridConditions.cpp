#include "tracking/GridConditions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace pellucida::test {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

class GridBuilder {
 public:
  std::vector<GridCondition> conditions;

  // The default cell and microscope, moved quickly.
  static Scenario quick() {
    Scenario s;
    s.motion = {.gap_um = 8.0,
                .approach_speed_um_per_s = 30.0,
                .indentation_um = 44.0,
                .indentation_speed_um_per_s = 24.0,
                .hold_s = 0.3,
                .retraction_speed_um_per_s = 0.0,
                .smoothing_s = 0.2};
    s.cell.center_x_um = 290.0;
    s.tools.needle_tip_radius_um = 1.5;  // finer than the finite elements': the tracker alone is measured here
    return s;
  }

  GridCondition& add(const std::string& name, Scenario scenario) {
    scenario.name = name;
    conditions.push_back({name, std::move(scenario)});
    return conditions.back();
  }
  template <class Change>
  GridCondition& vary(const std::string& name, Change&& change) {
    Scenario scenario = quick();
    change(scenario);
    return add(name, std::move(scenario));
  }
};

// A field of view for a pixel size: 600 x 400 um, but no more than 1400 x 900 px.
void set_pixel_size(Scenario& s, double pixel_size_um) {
  s.image.pixel_size_um = pixel_size_um;
  s.image.width_px = std::min(1400, static_cast<int>(std::lround(600.0 / pixel_size_um)));
  s.image.height_px = std::min(900, static_cast<int>(std::lround(400.0 / pixel_size_um)));
  s.cell.center_x_um = 0.48 * s.image.width_px * pixel_size_um;
  s.cell.center_y_um = 0.5 * s.image.height_px * pixel_size_um;
}

// The whole specimen and its tools smaller or larger, at a pixel size near the default one.
void set_outer_diameter(Scenario& s, double diameter_px) {
  const double scale = std::clamp(diameter_px * 0.825 / 105.0, 0.32, 3.0);
  s.cell.size_scale = scale;
  s.tools.needle_tip_radius_um = std::clamp(1.5 * scale, 0.6, 3.0);
  s.tools.needle_shaft_radius_um = std::clamp(6.0 * scale, 2.5, 12.0);
  s.motion.indentation_um *= scale;
  s.motion.indentation_speed_um_per_s *= scale;
  s.image.pixel_size_um = 105.0 * scale / diameter_px;
  s.image.width_px = std::clamp(static_cast<int>(std::lround(5.0 * diameter_px)), 320, 1300);
  s.image.height_px = std::clamp(static_cast<int>(std::lround(3.4 * diameter_px)), 240, 800);
  s.cell.center_x_um = 0.48 * s.image.width_px * s.image.pixel_size_um;
  s.cell.center_y_um = 0.5 * s.image.height_px * s.image.pixel_size_um;
}

void add_shipped(GridBuilder& grid) {
  // As shipped, at the speeds and lengths of a real experiment; the poor camera has noise, defocus, drift and debris at
  // once. The embryo's is the steepest dimple: 53 um.
  for (const char* name : {"default", "noisy", "embryo"})
    grid.add(name, load_scenario(name)).representative = std::string(name) != "noisy";
}

void add_camera(GridBuilder& grid) {
  // Grains of light: a frame's brightest pixel counts so many electrons; 500 is a grey veil of snow (5 % of the light).
  for (const double electrons : {9000.0, 2000.0, 500.0})
    grid.vary("noise " + number(electrons), [&](Scenario& s) { s.optics.full_well_electrons = electrons; })
        .representative = electrons == 2000.0;
  grid.vary("read noise 60", [](Scenario& s) {
    s.optics.full_well_electrons = 2000.0;
    s.optics.read_noise_electrons = 60.0;
  });
  grid.vary("16 bit", [](Scenario& s) { s.image.bit_depth = 16; }).representative = true;

  // Magnifications from 4 to 40 times. At 2 um/px the zona is 2.5 px thick.
  for (const double size : {0.2, 0.4, 0.825, 1.5, 2.0})
    grid.vary("pixel " + number(size) + " um", [&](Scenario& s) { set_pixel_size(s, size); }).representative =
        size == 0.4 || size == 1.5;
  for (const double diameter : {40.0, 64.0, 100.0, 200.0, 400.0})
    grid.vary("diameter " + number(diameter) + " px", [&](Scenario& s) { set_outer_diameter(s, diameter); })
        .representative = diameter == 64.0;

  // Lost frames, at the shipped scenarios' speeds: 6 and 10 px of needle between the frames seen, at most.
  Scenario slow = GridBuilder::quick();
  slow.motion.indentation_speed_um_per_s = 14.0;
  for (const int stride : {3, 5}) {
    GridCondition& c = grid.add(std::to_string(stride - 1) + " of " + std::to_string(stride) + " frames lost", slow);
    c.stride = stride;
    c.representative = stride == 5;
  }
}

void add_light(GridBuilder& grid) {
  // Out of focus as a whole: at 3 um the zona's two lines run into one grey band, 5 um thick.
  for (const double um : {0.0, 1.0, 2.0, 3.0})
    grid.vary("defocus " + number(um) + " um", [&](Scenario& s) { s.optics.defocus_um = um; }).representative =
        um == 1.0;
  for (const double contrast : {1.0, 0.6, 0.3})
    grid.vary("contrast " + number(contrast), [&](Scenario& s) { s.optics.contrast = contrast; }).representative =
        contrast == 0.3;
  grid.vary("no halo and no relief", [](Scenario& s) { s.optics.halo = s.optics.relief = 0.0; });
  grid.vary("halo 2", [](Scenario& s) { s.optics.halo = 2.0; });
  grid.vary("relief 2", [](Scenario& s) { s.optics.relief = 2.0; }).representative = true;
  grid.vary("coarse grain", [](Scenario& s) { s.optics.granularity = 2.5; });
  // A lamp out of line: half the light at one side, dark corners.
  grid.vary("uneven light",
            [](Scenario& s) {
              s.optics.gradient_ratio = 0.5;
              s.optics.vignette_ratio = 0.35;
              s.optics.contrast = 0.7;
            })
      .representative = true;
  // A shutter or an automatic exposure half-way, and a lamp that breathes.
  for (const double ratio : {0.6, 1.5})
    grid.vary("light step " + number(ratio), [&](Scenario& s) { s.lamp.step_ratio = ratio; }).representative =
        ratio == 0.6;
  grid.vary("flicker", [](Scenario& s) {
    s.lamp.flicker_ratio = 0.15;
    s.lamp.flicker_hz = 2.0;
  });
}

void add_motion(GridBuilder& grid) {
  for (const double speed : {5.0, 20.0})
    grid.vary("drift " + number(speed) + " um/s",
              [&](Scenario& s) {
                s.drift.x_um_per_s = -0.8 * speed;
                s.drift.y_um_per_s = 0.6 * speed;
              })
        .representative = speed == 20.0;
  // The stage or the camera turns: 20 deg/s are 0.7 px a frame at the membrane.
  for (const double speed : {5.0, 20.0})
    grid.vary("rotation " + number(speed) + " deg/s", [&](Scenario& s) { s.drift.rotation_deg_per_s = speed; })
        .representative = speed == 20.0;
  grid.vary("jumps of 30 px",
            [](Scenario& s) {
              s.drift.jump_x_px = 24.0;
              s.drift.jump_y_px = -18.0;
              s.drift.jump_period_s = 0.5;
            })
      .representative = true;
}

void add_tools(GridBuilder& grid) {
  // The needle from every side, opposite the holder; and beside it, on both sides of the holder's axis.
  for (const double angle : {0.0, 45.0, 90.0, 135.0, 225.0, 270.0, 315.0, 17.0, 73.0, 201.0})
    grid.vary("holder at " + number(angle) + " deg",
              [&](Scenario& s) {
                s.tools.holder_angle_deg = angle;
                s.cell.center_x_um = 300.0;
              })
        .representative = true;
  for (const int configuration : {2, 3})
    for (const bool mirrored : {false, true})
      for (const double angle : {180.0, 110.0})
        grid.vary("configuration " + std::to_string(configuration) + (mirrored ? " mirrored" : "") + " holder " +
                      number(angle),
                  [&](Scenario& s) {
                    s.tools.configuration = configuration;
                    s.tools.mirrored = mirrored;
                    s.tools.holder_angle_deg = angle;
                    s.cell.center_x_um = 300.0;
                  })
            .representative = angle == 180.0 && configuration == 3;
  // The needle above or below the cell's plane; at 5 um its edges are two soft shades, and the tip fades.
  for (const double um : {1.5, 3.0, 5.0})
    grid.vary("needle defocus " + number(um) + " um", [&](Scenario& s) { s.optics.needle_defocus_um = um; })
        .representative = true;
}

void add_dish(GridBuilder& grid) {
  grid.vary("debris touching", [](Scenario& s) { s.debris.touching_count = 8; }).representative = true;
  grid.vary("large debris touching", [](Scenario& s) {
    s.debris.touching_count = 4;
    s.debris.touching_radius_um = 6.0;
  });
  grid.vary("debris everywhere", [](Scenario& s) {
    s.debris.count = 60;
    s.debris.max_radius_um = 4.0;
  });
  grid.vary("particles passing", [](Scenario& s) {
    s.debris.passing_count = 25;
    s.debris.max_radius_um = 4.0;
  });
  // Others lie about, but only one is held: at the border, or whole and far enough to be no hindrance.
  grid.vary("second cell at the border", [](Scenario& s) {
    s.bystander.cell_radius_um = 50.0;
    s.bystander.cell_x_um = 420.0;
    s.bystander.cell_y_um = 380.0;
  });
  grid.vary("second cell", [](Scenario& s) {
    s.bystander.cell_radius_um = 50.0;
    s.bystander.cell_x_um = 420.0;
    s.bystander.cell_y_um = 320.0;
  });
  grid.vary("air bubble", [](Scenario& s) {
    s.bystander.bubble_radius_um = 35.0;
    s.bystander.bubble_x_um = 430.0;
    s.bystander.bubble_y_um = 90.0;
  });
}

void add_cell(GridBuilder& grid) {
  grid.vary("puncture",
            [](Scenario& s) {
              s.motion.indentation_um = 60.0;
              s.motion.indentation_speed_um_per_s = 28.0;
              s.motion.retraction_speed_um_per_s = 90.0;
              s.puncture.enabled = true;
            })
      .representative = true;
  grid.vary("in and out again", [](Scenario& s) {
    s.motion.indentation_um = 36.0;
    s.motion.retraction_speed_um_per_s = 40.0;
  });
  grid.vary("perivitelline gap 4 um", [](Scenario& s) { s.cell.perivitelline_gap_um = 4.0; }).representative = true;
}

}  // namespace

void PrintTo(const GridCondition& condition, std::ostream* out) {
  *out << condition.name;
}

std::vector<GridCondition> grid_conditions() {
  GridBuilder grid;
  add_shipped(grid);
  add_camera(grid);
  add_light(grid);
  add_motion(grid);
  add_tools(grid);
  add_dish(grid);
  add_cell(grid);
  return std::move(grid.conditions);
}

}  // namespace pellucida::test
