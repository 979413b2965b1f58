#include "pellucida/simulation/Scenario.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"
#include "pellucida/core/Table.h"

namespace pellucida {
namespace {

std::string named(std::string_view scenario) {
  return "scenario '" + std::string(scenario) + "'";
}

Scenario scenario_from(const nlohmann::ordered_json& json, std::string_view name) {
  Scenario scenario;
  scenario.name = name;
  if (const auto fault = read_fields(json, fields_of(scenario))) throw UsageError(named(name) + ": " + *fault);
  validate(scenario);
  return scenario;
}

}  // namespace

Scenario parse_scenario(std::string_view json_text, std::string_view name) {
  return scenario_from(parse_json_object(json_text, named(name)), name);
}

void validate(const Scenario& scenario) {
  const auto refuse = [&](const std::string& fault) { throw UsageError(named(scenario.name) + ": " + fault); };
  const int depth = scenario.image.bit_depth;
  if (depth != 8 && depth != 16) refuse("image.bit_depth is " + std::to_string(depth) + "; allowed: 8 or 16");
  Scenario checked = scenario;
  if (const auto fault = range_fault(fields_of(checked))) refuse(*fault);
  const Scenario::Tools& tools = scenario.tools;
  if (tools.needle_shaft_radius_um < tools.needle_tip_radius_um) {
    refuse("tools.needle_shaft_radius_um is " + csv_number(tools.needle_shaft_radius_um) +
           ", less than tools.needle_tip_radius_um; a needle widens away from its tip");
  }
}

Scenario load_scenario(std::string_view name_or_file) {
  std::error_code ignored;
  const auto comma = std::filesystem::exists(name_or_file, ignored) ? std::string_view::npos : name_or_file.find(',');
  auto json = read_json_object(find_resource("scenarios", name_or_file.substr(0, comma), ".json"));
  if (comma != std::string_view::npos) {
    if (const auto fault = replace_keys(json, name_or_file.substr(comma + 1)))
      throw UsageError(named(name_or_file) + ": " + *fault);
  }
  return scenario_from(json, name_or_file);
}

std::vector<std::string> scenario_names() {
  return list_resources("scenarios", ".json");
}

}  // namespace pellucida
