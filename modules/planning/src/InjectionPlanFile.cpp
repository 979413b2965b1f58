// A plan as JSON. Only what was chosen is read back; the rest is computed from it anew.
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/planning/InjectionPlan.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

struct Option {
  const char* key;
  double PlanOptions::*place;
};
constexpr Option kOptions[] = {
    {"approach_distance_um", &PlanOptions::approach_distance_um},
    {"overshoot_um", &PlanOptions::overshoot_um},
    {"path_radius_um", &PlanOptions::path_radius_um},
    {"needle_clearance_um", &PlanOptions::needle_clearance_um},
    {"holder_radius_um", &PlanOptions::holder_radius_um},
    {"cone_half_angle_rad", &PlanOptions::cone_half_angle_rad},
    {"approach_speed_um_per_s", &PlanOptions::approach_speed_um_per_s},
    {"insertion_speed_um_per_s", &PlanOptions::insertion_speed_um_per_s},
    {"removal_speed_um_per_s", &PlanOptions::removal_speed_um_per_s},
};

Json json_of(const PlainVector3& v) {
  return Json::array({v.x, v.y, v.z});
}

// Reads values by key; every fault names the text it was in and the key.
class Reader {
 public:
  Reader(const Json& json, std::string what) : json_(json), what_(std::move(what)) {}

  const Json& at(const char* key) const {
    if (!json_.is_object() || !json_.contains(key)) fail(key, "is missing; add it");
    return json_[key];
  }
  double number(const char* key) const {
    if (!at(key).is_number()) fail(key, "must be a number");
    return at(key).get<double>();
  }
  PlainVector3 vector(const char* key) const {
    const Json& value = at(key);
    const bool three =
        value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
    if (!three) fail(key, "must be a list of three numbers");
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }
  [[noreturn]] void fail(const char* key, const char* text) const {
    throw InputError(what_ + ": \"" + key + "\" " + text);
  }

 private:
  const Json& json_;
  std::string what_;
};

}  // namespace

std::string to_json(const InjectionPlan& plan) {
  Json cell = {{"center_um", json_of(plan.cell.center_um)},
               {"outer_radius_um", plan.cell.outer_radius_um},
               {"inner_radius_um", plan.cell.inner_radius_um},
               {"needle_direction", json_of(plan.cell.needle_direction)}};
  if (plan.cell.holder_known) {
    cell["holder_mouth_um"] = json_of(plan.cell.holder_mouth_um);
    cell["holder_direction"] = json_of(plan.cell.holder_direction);
  }
  Json options;
  for (const Option& option : kOptions) options[option.key] = plan.options.*option.place;
  const Json root = {{"schema", "pellucida-injection-plan"},
                     {"schema_version", 1},
                     {"cell", cell},
                     {"target_um", json_of(plan.target_um)},
                     {"options", options},
                     {"axis", json_of(plan.axis)},
                     {"entry_um", json_of(plan.entry_um)},
                     {"approach_um", json_of(plan.approach_um)},
                     {"depth_um", plan.depth_um}};
  return root.dump(2) + "\n";
}

InjectionPlan plan_from_json(std::string_view json, const std::string& what) {
  const Json root = parse_json_object(json, what);
  const Reader in(root, what);
  if (in.at("schema") != "pellucida-injection-plan") in.fail("schema", "must be \"pellucida-injection-plan\"");
  if (in.at("schema_version") != 1) in.fail("schema_version", "is newer than this program; update it");
  const Reader in_cell(in.at("cell"), what + ": cell");
  CellGeometry cell;
  cell.center_um = in_cell.vector("center_um");
  cell.outer_radius_um = in_cell.number("outer_radius_um");
  cell.inner_radius_um = in_cell.number("inner_radius_um");
  cell.needle_direction = in_cell.vector("needle_direction");
  cell.holder_known = in.at("cell").contains("holder_mouth_um");
  if (cell.holder_known) {
    cell.holder_mouth_um = in_cell.vector("holder_mouth_um");
    cell.holder_direction = in_cell.vector("holder_direction");
  }
  const Reader in_options(in.at("options"), what + ": options");
  PlanOptions options;
  for (const Option& option : kOptions) options.*option.place = in_options.number(option.key);
  const auto plan = plan_injection(cell, in.vector("target_um"), options);
  if (!plan) throw InputError(what + ": " + to_string(plan.error()));
  return *plan;
}

void write_plan(const InjectionPlan& plan, const std::filesystem::path& file) {
  std::ofstream stream(file);
  stream << to_json(plan);
  stream.flush();
  if (!stream) throw OutputError(file.string() + ": the plan can't be written; check disk space and permissions");
}

InjectionPlan read_plan(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": the plan can't be read; check the path and its permissions");
  std::ostringstream text;
  text << stream.rdbuf();
  return plan_from_json(text.str(), file.string());
}

}  // namespace pellucida
