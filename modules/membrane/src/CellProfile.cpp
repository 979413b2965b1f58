#include "pellucida/membrane/CellProfile.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

// Sets the fields from `json` and checks each by itself. Keys that the fields don't have are read elsewhere.
void read_checked(const Json& json, const FieldList& fields, const std::string& where) {
  auto fault = read_fields(json, fields, UnknownKeys::kIgnored);
  if (!fault) fault = range_fault(fields);
  if (fault) throw InputError(where + ": " + *fault);
}

template <class Entry>
void read_list(const Json& root, const char* key, const std::string& where, std::vector<Entry>& entries) {
  const auto list = root.find(key);
  if (list == root.end()) return;
  if (!list->is_array()) throw InputError(where + ": " + key + " must be a list");
  for (const Json& json : *list) {
    const std::string place = where + ": " + key + '[' + std::to_string(entries.size()) + ']';
    if (!json.is_object()) throw InputError(place + " must be a group of keys, {...}");
    read_checked(json, fields_of(entries.emplace_back()), place);
  }
}

template <class Entry>
Json list_json(std::vector<Entry> entries) {
  Json list = Json::array();
  for (Entry& entry : entries) write_fields(fields_of(entry), list.emplace_back(Json::object()));
  return list;
}

void read_sources(const Json& root, const std::string& where, CellProfile& profile) {
  const auto sources = root.find("sources");
  if (sources == root.end() || !sources->is_object()) throw InputError(where + ": sources must be an object of texts");
  for (const auto& [what, text] : sources->items()) {
    if (!text.is_string()) throw InputError(where + ": sources." + what + " must be a text");
    profile.sources.push_back({what, text.get<std::string>()});
  }
}

void read_geometry_range(const Json& root, const std::string& where, CellProfile& profile) {
  GeometryRange& range = profile.geometry_range;
  read_checked(root, fields_of(range), where);
  const struct {
    const char* key;
    double from, to;
  } pairs[] = {{"thickness", range.thickness_from_ratio, range.thickness_to_ratio},
               {"tip", range.tip_from_ratio, range.tip_to_ratio},
               {"holder", range.holder_from_ratio, range.holder_to_ratio}};
  for (const auto& pair : pairs) {
    if (pair.from < pair.to) continue;
    throw InputError(where + ": geometry_range." + pair.key + "_from_ratio must be below " + pair.key + "_to_ratio");
  }
}

// What no field can tell by itself.
void check_together(const CellProfile& p, const std::string& where) {
  const struct {
    const char* key;
    double value_um, limit_um;
  } lengths[] = {{"geometry.thickness_um", p.thickness_um, p.mid_radius_um},
                 {"geometry.inner_radius_um", p.inner_radius_um, p.mid_radius_um},
                 {"material.puncture_indentation_um", p.puncture_indentation_um, 2.0 * p.mid_radius_um},
                 {"contact.tip_radius_um", p.tip_radius_um, p.mid_radius_um},
                 {"contact.holder_ring_um", p.holder_ring_um, p.mid_radius_um},
                 {"contact.holder_half_width_um", p.holder_half_width_um, p.holder_ring_um}};
  for (const auto& length : lengths) {
    if (const auto fault = range_fault(length.key, length.value_um, above(0, length.limit_um)))
      throw InputError(where + ": " + *fault);
  }
  if (std::abs(p.inner_radius_um + 0.5 * p.thickness_um - p.mid_radius_um) > 0.01 * p.thickness_um)
    throw InputError(where + ": geometry.inner_radius_um must be mid_radius_um less half of thickness_um");
}

CellProfile profile_from(const Json& root, const std::string& where) {
  if (root.value("schema", Json()) != "pellucida-cell-profile")
    throw InputError(where + ": schema must be \"pellucida-cell-profile\"");
  if (root.value("schema_version", Json()) != 1)
    throw InputError(where + ": schema_version must be 1; update the program or the file");

  CellProfile p;
  read_checked(root, fields_of(p), where);
  check_together(p, where);
  read_sources(root, where, p);
  if (!root.contains("errors")) throw InputError(where + ": errors is missing; add it");
  read_list(root, "errors", where, p.errors);

  // What older profiles don't have.
  read_list(root, "references", where, p.references);
  read_list(root, "geometry_terms", where, p.geometry_terms);
  read_list(root, "geometry_pressure_terms", where, p.geometry_pressure_terms);
  if (p.geometry_terms.empty() && !p.geometry_pressure_terms.empty())
    throw InputError(where + ": geometry_pressure_terms needs geometry_terms and geometry_range; add them");
  if (!p.geometry_terms.empty()) read_geometry_range(root, where, p);
  read_list(root, "relaxation_arms", where, p.relaxation_arms);
  if (!root.contains("relaxation_arms")) return p;
  try {
    Relaxation checked(p.relaxation_arms);
  } catch (const UsageError& error) {
    throw InputError(where + ": relaxation_arms is wrong: " + error.what());
  }
  read_checked(root, relaxation_fields_of(p), where);
  return p;
}

}  // namespace

CellProfile read_profile(const std::filesystem::path& file) {
  return profile_from(read_json_object(file), file.string());
}

CellProfile parse_profile(std::string_view text, const std::string& where) {
  return profile_from(parse_json_object(text, where), where);
}

CellProfile load_profile(std::string_view name_or_file) {
  return read_profile(find_resource("profiles", name_or_file, ".json"));
}

std::string to_json(const CellProfile& profile) {
  CellProfile p = profile;
  Json root{{"schema", "pellucida-cell-profile"},
            {"schema_version", 1},
            {"name", ""},
            {"description", ""},
            {"sources", Json::object()}};
  for (const auto& [what, where] : p.sources) root["sources"][what] = where;
  write_fields(fields_of(p), root);
  root["references"] = list_json(p.references);
  root["errors"] = list_json(p.errors);
  if (!p.geometry_terms.empty()) {
    write_fields(fields_of(p.geometry_range), root);
    root["geometry_terms"] = list_json(p.geometry_terms);
    if (!p.geometry_pressure_terms.empty()) root["geometry_pressure_terms"] = list_json(p.geometry_pressure_terms);
  }
  if (!p.relaxation_arms.empty()) {
    root["relaxation_arms"] = list_json(p.relaxation_arms);
    write_fields(relaxation_fields_of(p), root);
  }
  return root.dump(2);
}

}  // namespace pellucida
