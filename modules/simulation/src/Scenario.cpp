#include "pellucida/simulation/Scenario.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"
#include "pellucida/simulation/CellReference.h"

namespace pellucida {
namespace {

using Json = nlohmann::json;

std::string where(std::string_view scenario, const std::string& key) {
  return "scenario '" + std::string(scenario) + "': " + key;
}

// One group of keys: takes what it knows, then complains about the rest.
class Group {
 public:
  Group(const Json& parent, const std::string& name, std::string_view scenario) : name_(name), scenario_(scenario) {
    if (!parent.contains(name)) return;
    json_ = parent.at(name);
    if (!json_.is_object())
      throw UsageError(where(scenario_, name_) + " is no group of keys; write \"" + name_ + "\": {...}");
  }

  void take(const char* key, double& value) {
    if (const Json* found = find(key)) {
      if (!found->is_number()) wrong(key, *found, "a number");
      value = found->get<double>();
    }
  }
  void take(const char* key, int& value) {
    if (const Json* found = find(key)) {
      if (!found->is_number_integer()) wrong(key, *found, "a whole number");
      const auto number = found->get<std::int64_t>();
      if (std::abs(number) > 1000000000) wrong(key, *found, "a whole number below 1e9");
      value = static_cast<int>(number);
    }
  }
  void take(const char* key, bool& value) {
    if (const Json* found = find(key)) {
      if (!found->is_boolean()) wrong(key, *found, "true or false");
      value = found->get<bool>();
    }
  }
  void take(const char* key, std::string& value) {
    if (const Json* found = find(key)) {
      if (!found->is_string()) wrong(key, *found, "a text");
      value = found->get<std::string>();
    }
  }

  // Call after the last `take`.
  void finish() const {
    for (const auto& [key, value] : json_.items())
      if (!known_.contains(key)) {
        std::string list;
        for (const auto& name : known_) list += (list.empty() ? "" : ", ") + name;
        throw UsageError(where(scenario_, name_ + "." + key) + " is an unknown key; known: " + list);
      }
  }

 private:
  const Json* find(const char* key) {
    known_.insert(key);
    const auto found = json_.find(key);
    return found == json_.end() ? nullptr : &*found;
  }
  [[noreturn]] void wrong(const char* key, const Json& value, const char* wanted) const {
    throw UsageError(where(scenario_, name_ + "." + key) + " is " + value.dump() + ", but must be " + wanted);
  }

  std::string name_, scenario_;
  Json json_ = Json::object();
  std::set<std::string> known_;
};

void require_range(const Scenario& scenario, const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return;  // false for NaN too
  throw UsageError(where(scenario.name, key) + " is " + (std::isnan(value) ? "not a number" : csv_number(value)) +
                   "; allowed: " + csv_number(low) + " to " + csv_number(high));
}

}  // namespace

Scenario parse_scenario(std::string_view json_text, std::string_view name) {
  Json json;
  try {
    json = Json::parse(json_text, nullptr, true, true);
  } catch (const Json::parse_error& error) {
    throw InputError("scenario '" + std::string(name) + "' is no JSON: byte " + std::to_string(error.byte) +
                     "; correct the file or use a shipped scenario");
  }
  if (!json.is_object()) throw InputError("scenario '" + std::string(name) + "' is no JSON object; write {...}");

  Scenario scenario;
  scenario.name = name;

  Group image(json, "image", name);
  image.take("width_px", scenario.image.width_px);
  image.take("height_px", scenario.image.height_px);
  image.take("pixel_size_um", scenario.image.pixel_size_um);
  image.take("bit_depth", scenario.image.bit_depth);
  image.take("frame_rate_hz", scenario.image.frame_rate_hz);
  image.take("duration_s", scenario.image.duration_s);
  image.finish();

  Group cell(json, "cell", name);
  cell.take("reference", scenario.cell.reference);
  cell.take("center_x_um", scenario.cell.center_x_um);
  cell.take("center_y_um", scenario.cell.center_y_um);
  cell.take("size_scale", scenario.cell.size_scale);
  cell.take("perivitelline_gap_um", scenario.cell.perivitelline_gap_um);
  cell.finish();

  Group tools(json, "tools", name);
  tools.take("configuration", scenario.tools.configuration);
  tools.take("holder_angle_deg", scenario.tools.holder_angle_deg);
  tools.take("mirrored", scenario.tools.mirrored);
  tools.take("needle_tip_radius_um", scenario.tools.needle_tip_radius_um);
  tools.take("needle_taper_deg", scenario.tools.needle_taper_deg);
  tools.take("needle_shaft_radius_um", scenario.tools.needle_shaft_radius_um);
  tools.finish();

  Group motion(json, "motion", name);
  motion.take("gap_um", scenario.motion.gap_um);
  motion.take("approach_speed_um_per_s", scenario.motion.approach_speed_um_per_s);
  motion.take("indentation_um", scenario.motion.indentation_um);
  motion.take("indentation_speed_um_per_s", scenario.motion.indentation_speed_um_per_s);
  motion.take("hold_s", scenario.motion.hold_s);
  motion.take("retraction_speed_um_per_s", scenario.motion.retraction_speed_um_per_s);
  motion.take("smoothing_s", scenario.motion.smoothing_s);
  motion.finish();

  Group puncture(json, "puncture", name);
  puncture.take("enabled", scenario.puncture.enabled);
  puncture.take("indentation_um", scenario.puncture.indentation_um);
  puncture.take("residual_um", scenario.puncture.residual_um);
  puncture.take("relaxation_s", scenario.puncture.relaxation_s);
  puncture.take("spread_ratio", scenario.puncture.spread_ratio);
  puncture.finish();

  Group optics(json, "optics", name);
  optics.take("background_ratio", scenario.optics.background_ratio);
  optics.take("contrast", scenario.optics.contrast);
  optics.take("halo", scenario.optics.halo);
  optics.take("relief", scenario.optics.relief);
  optics.take("granularity", scenario.optics.granularity);
  optics.take("gradient_ratio", scenario.optics.gradient_ratio);
  optics.take("gradient_angle_deg", scenario.optics.gradient_angle_deg);
  optics.take("vignette_ratio", scenario.optics.vignette_ratio);
  optics.take("defocus_um", scenario.optics.defocus_um);
  optics.take("needle_defocus_um", scenario.optics.needle_defocus_um);
  optics.take("full_well_electrons", scenario.optics.full_well_electrons);
  optics.take("read_noise_electrons", scenario.optics.read_noise_electrons);
  optics.take("noise", scenario.optics.noise);
  optics.finish();

  Group drift(json, "drift", name);
  drift.take("x_um_per_s", scenario.drift.x_um_per_s);
  drift.take("y_um_per_s", scenario.drift.y_um_per_s);
  drift.take("rotation_deg_per_s", scenario.drift.rotation_deg_per_s);
  drift.take("jump_x_px", scenario.drift.jump_x_px);
  drift.take("jump_y_px", scenario.drift.jump_y_px);
  drift.take("jump_period_s", scenario.drift.jump_period_s);
  drift.finish();

  Group lamp(json, "lamp", name);
  lamp.take("step_time_s", scenario.lamp.step_time_s);
  lamp.take("step_ratio", scenario.lamp.step_ratio);
  lamp.take("flicker_ratio", scenario.lamp.flicker_ratio);
  lamp.take("flicker_hz", scenario.lamp.flicker_hz);
  lamp.finish();

  Group debris(json, "debris", name);
  debris.take("count", scenario.debris.count);
  debris.take("max_radius_um", scenario.debris.max_radius_um);
  debris.take("touching_count", scenario.debris.touching_count);
  debris.take("touching_radius_um", scenario.debris.touching_radius_um);
  debris.take("passing_count", scenario.debris.passing_count);
  debris.take("passing_speed_um_per_s", scenario.debris.passing_speed_um_per_s);
  debris.finish();

  Group bystander(json, "bystander", name);
  bystander.take("cell_radius_um", scenario.bystander.cell_radius_um);
  bystander.take("cell_x_um", scenario.bystander.cell_x_um);
  bystander.take("cell_y_um", scenario.bystander.cell_y_um);
  bystander.take("bubble_radius_um", scenario.bystander.bubble_radius_um);
  bystander.take("bubble_x_um", scenario.bystander.bubble_x_um);
  bystander.take("bubble_y_um", scenario.bystander.bubble_y_um);
  bystander.finish();

  // The keys outside the groups.
  const std::set<std::string> groups{"image",  "cell",  "tools", "motion", "puncture",
                                     "optics", "drift", "lamp",  "debris", "bystander"};
  for (const auto& [key, value] : json.items()) {
    if (groups.contains(key)) continue;
    if (key == "description" && value.is_string()) {
      scenario.description = value.get<std::string>();
    } else if (key == "seed" && value.is_number_unsigned()) {
      scenario.seed = value.get<std::uint64_t>();
    } else if (key == "description" || key == "seed") {
      throw UsageError(where(name, key) + " is " + value.dump() + ", but must be " +
                       (key == "seed" ? "a whole number, 0 or more" : "a text"));
    } else {
      throw UsageError(
          where(name, key) +
          " is an unknown key; known: description, seed, image, cell, tools, motion, puncture, optics, drift, "
          "lamp, debris, bystander");
    }
  }
  validate(scenario);
  return scenario;
}

void validate(const Scenario& s) {
  auto check = [&s](const char* key, double value, double low, double high) {
    require_range(s, key, value, low, high);
  };
  check("image.width_px", s.image.width_px, 64, 4096);
  check("image.height_px", s.image.height_px, 64, 4096);
  check("image.pixel_size_um", s.image.pixel_size_um, 0.05, 5);
  if (s.image.bit_depth != 8 && s.image.bit_depth != 16)
    throw UsageError(where(s.name, "image.bit_depth") + " is " + std::to_string(s.image.bit_depth) +
                     "; allowed: 8 or 16");
  check("image.frame_rate_hz", s.image.frame_rate_hz, 1, 1000);
  check("image.duration_s", s.image.duration_s, 0, 3600);

  check("cell.center_x_um", s.cell.center_x_um, -1e4, 1e4);
  check("cell.center_y_um", s.cell.center_y_um, -1e4, 1e4);
  check("cell.size_scale", s.cell.size_scale, 0.3, 3);
  check("cell.perivitelline_gap_um", s.cell.perivitelline_gap_um, 0, 8);

  check("tools.configuration", s.tools.configuration, 1, 4);
  check("tools.holder_angle_deg", s.tools.holder_angle_deg, -360, 360);
  check("tools.needle_tip_radius_um", s.tools.needle_tip_radius_um, 0.5, 3);
  check("tools.needle_taper_deg", s.tools.needle_taper_deg, 0.5, 6);
  check("tools.needle_shaft_radius_um", s.tools.needle_shaft_radius_um, 1, 12);
  if (s.tools.needle_shaft_radius_um < s.tools.needle_tip_radius_um)
    throw UsageError(where(s.name, "tools.needle_shaft_radius_um") + " is " +
                     csv_number(s.tools.needle_shaft_radius_um) +
                     ", less than tools.needle_tip_radius_um; a needle widens away from its tip");

  check("motion.gap_um", s.motion.gap_um, 0, 300);
  check("motion.approach_speed_um_per_s", s.motion.approach_speed_um_per_s, 1, 500);
  check("motion.indentation_um", s.motion.indentation_um, 0, 200);
  check("motion.indentation_speed_um_per_s", s.motion.indentation_speed_um_per_s, 1, 500);
  check("motion.hold_s", s.motion.hold_s, 0, 600);
  check("motion.retraction_speed_um_per_s", s.motion.retraction_speed_um_per_s, 0, 500);
  check("motion.smoothing_s", s.motion.smoothing_s, 0, 5);

  check("puncture.indentation_um", s.puncture.indentation_um, 0.5, 200);
  check("puncture.residual_um", s.puncture.residual_um, 0, 20);
  check("puncture.relaxation_s", s.puncture.relaxation_s, 0.001, 10);
  check("puncture.spread_ratio", s.puncture.spread_ratio, 0, 0.5);

  check("optics.background_ratio", s.optics.background_ratio, 0.1, 0.9);
  check("optics.contrast", s.optics.contrast, 0.1, 2);
  check("optics.halo", s.optics.halo, 0, 2);
  check("optics.relief", s.optics.relief, 0, 2);
  check("optics.granularity", s.optics.granularity, 0, 3);
  check("optics.gradient_ratio", s.optics.gradient_ratio, 0, 0.6);
  check("optics.gradient_angle_deg", s.optics.gradient_angle_deg, -360, 360);
  check("optics.vignette_ratio", s.optics.vignette_ratio, 0, 0.6);
  check("optics.defocus_um", s.optics.defocus_um, 0, 10);
  check("optics.needle_defocus_um", s.optics.needle_defocus_um, 0, 10);
  check("optics.full_well_electrons", s.optics.full_well_electrons, 100, 1e6);
  check("optics.read_noise_electrons", s.optics.read_noise_electrons, 0, 1000);

  check("drift.x_um_per_s", s.drift.x_um_per_s, -50, 50);
  check("drift.y_um_per_s", s.drift.y_um_per_s, -50, 50);
  check("drift.rotation_deg_per_s", s.drift.rotation_deg_per_s, -90, 90);
  check("drift.jump_x_px", s.drift.jump_x_px, -200, 200);
  check("drift.jump_y_px", s.drift.jump_y_px, -200, 200);
  check("drift.jump_period_s", s.drift.jump_period_s, 0.02, 600);

  check("lamp.step_time_s", s.lamp.step_time_s, 0, 3600);
  check("lamp.step_ratio", s.lamp.step_ratio, 0.2, 1.6);
  check("lamp.flicker_ratio", s.lamp.flicker_ratio, 0, 0.3);
  check("lamp.flicker_hz", s.lamp.flicker_hz, 0.01, 100);

  check("debris.count", s.debris.count, 0, 500);
  check("debris.max_radius_um", s.debris.max_radius_um, 0.5, 10);
  check("debris.touching_count", s.debris.touching_count, 0, 60);
  check("debris.touching_radius_um", s.debris.touching_radius_um, 0.5, 10);
  check("debris.passing_count", s.debris.passing_count, 0, 60);
  check("debris.passing_speed_um_per_s", s.debris.passing_speed_um_per_s, 0, 500);

  check("bystander.cell_radius_um", s.bystander.cell_radius_um, 0, 150);
  check("bystander.cell_x_um", s.bystander.cell_x_um, -1e4, 1e4);
  check("bystander.cell_y_um", s.bystander.cell_y_um, -1e4, 1e4);
  check("bystander.bubble_radius_um", s.bystander.bubble_radius_um, 0, 150);
  check("bystander.bubble_x_um", s.bystander.bubble_x_um, -1e4, 1e4);
  check("bystander.bubble_y_um", s.bystander.bubble_y_um, -1e4, 1e4);
}

Scenario load_scenario(std::string_view name_or_file) {
  const auto file = find_resource("scenarios", name_or_file, ".json");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf()))
    throw InputError("scenario '" + file.string() +
                     "' can't be read, or is empty; give a JSON file or the name of a shipped one");
  return parse_scenario(text.str(), name_or_file);
}

std::vector<std::string> scenario_names() {
  return list_resources("scenarios", ".json");
}

}  // namespace pellucida
