#include "pellucida/microscopy/Look.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

std::string named(std::string_view look) {
  return "look '" + std::string(look) + "'";
}

Look look_from(const nlohmann::ordered_json& json, std::string_view name) {
  Look look;
  look.name = name;
  if (const auto fault = read_fields(json, fields_of(look))) throw UsageError(named(name) + ": " + *fault);
  validate(look);
  return look;
}

}  // namespace

Look parse_look(std::string_view json_text, std::string_view name) {
  return look_from(parse_json_object(json_text, named(name)), name);
}

Look load_look(std::string_view name_or_file) {
  return look_from(read_json_object(find_resource("looks", name_or_file, ".json")), name_or_file);
}

void validate(const Look& look) {
  const auto refuse = [&](const std::string& fault) { throw UsageError(named(look.name) + ": " + fault); };
  const auto one_of = [&](const char* key, const std::string& value, std::initializer_list<const char*> known) {
    if (std::any_of(known.begin(), known.end(), [&](const char* name) { return value == name; })) return;
    std::string list;
    for (const char* name : known) list += (list.empty() ? "" : ", ") + std::string(name);
    refuse(std::string(key) + " is '" + value + "'; allowed: " + list);
  };
  one_of("contrast.kind", look.contrast.kind, {"bright-field", "hoffman", "dic", "phase", "dark-field"});
  one_of("needle.end", look.needle.end, {"closed", "open", "bevelled"});
  Look checked = look;
  if (const auto fault = range_fault(fields_of(checked))) refuse(*fault);
}

std::vector<std::string> look_names() {
  return list_resources("looks", ".json");
}

}  // namespace pellucida
