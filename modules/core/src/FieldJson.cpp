#include "pellucida/core/FieldJson.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <type_traits>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

// Takes the value over, or says what it should be.
const char* take(const Json& json, double& value) {
  if (!json.is_number()) return "a number";
  value = json.get<double>();
  return nullptr;
}
const char* take(const Json& json, int& value) {
  constexpr double kMost = 1e9;
  if (!json.is_number() || json.get<double>() != std::floor(json.get<double>())) return "a whole number";
  if (std::abs(json.get<double>()) > kMost) return "a whole number below 1e9";
  value = json.get<int>();
  return nullptr;
}
const char* take(const Json& json, std::uint64_t& value) {
  if (!json.is_number_unsigned()) return "a whole number, 0 or more";
  value = json.get<std::uint64_t>();
  return nullptr;
}
const char* take(const Json& json, bool& value) {
  if (!json.is_boolean()) return "true or false";
  value = json.get<bool>();
  return nullptr;
}
const char* take(const Json& json, std::string& value) {
  if (!json.is_string()) return "a text";
  value = json.get<std::string>();
  return nullptr;
}

bool is_group(const FieldList& fields, const std::string& key) {
  for (const FieldPlace& field : fields)
    if (field.key.starts_with(key + '.')) return true;
  return false;
}

std::optional<std::string> read_group(const Json& json, const std::string& group, const FieldList& fields,
                                      UnknownKeys unknown) {
  for (const auto& item : json.items()) {
    const std::string& name = item.key();
    const Json& value = item.value();
    const std::string key = group.empty() ? name : group + '.' + name;
    const bool dotted = name.find('.') != std::string::npos;  // in the file itself; groups are objects there
    const FieldPlace* field = dotted ? nullptr : fields.find(key);
    if (field) {
      const char* wanted = std::visit([&](auto* place) { return take(value, *place); }, field->value);
      if (wanted) return key + " is " + value.dump() + ", but must be " + wanted;
    } else if (!dotted && is_group(fields, key)) {
      if (!value.is_object()) return key + " is no group of keys; write \"" + name + "\": {...}";
      if (auto fault = read_group(value, key, fields, unknown)) return fault;
    } else if (unknown == UnknownKeys::kRefused) {
      return key + " is an unknown key; known: " + fields.names_in(group);
    }
  }
  return std::nullopt;
}

// "image.width_px" as "/image/width_px".
Json::json_pointer pointer_to(const FieldPlace& field) {
  std::string path = '/' + field.key;
  for (char& c : path)
    if (c == '.') c = '/';
  return Json::json_pointer(path);
}

}  // namespace

std::optional<std::string> read_fields(const Json& json, const FieldList& fields, UnknownKeys unknown) {
  if (auto fault = read_group(json, "", fields, unknown)) return fault;
  for (const FieldPlace& field : fields) {
    if (field.need == FieldNeed::kOptional) continue;
    if (!json.contains(pointer_to(field))) return field.key + " is missing; add it";
    if (field.value_text().empty()) return field.key + " is empty; write a text";
  }
  return std::nullopt;
}

void write_fields(const FieldList& fields, Json& json) {
  for (const FieldPlace& field : fields)
    std::visit([&](const auto* value) { json[pointer_to(field)] = *value; }, field.value);
}

Json parse_json_object(std::string_view text, const std::string& what) {
  Json json;
  try {
    json = Json::parse(text, nullptr, true, true);
  } catch (const Json::parse_error& error) {
    throw InputError(what + " is no JSON: byte " + std::to_string(error.byte) + "; correct it or use a shipped one");
  } catch (const Json::out_of_range&) {
    throw InputError(what + " has a number too large to be one; correct it or use a shipped one");
  }
  if (!json.is_object()) throw InputError(what + " is no JSON object; write {...}");
  return json;
}

Json read_json_object(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || text.bad()) throw InputError(file.string() + ": can't be read; check the path and its permissions");
  return parse_json_object(text.str(), file.string());
}

std::optional<std::string> replace_keys(Json& json, std::string_view settings) {
  while (!settings.empty()) {
    const std::string setting(settings.substr(0, settings.find(',')));
    settings.remove_prefix(std::min(settings.size(), setting.size() + 1));
    const auto equals = setting.find('=');
    const std::string text = equals == std::string::npos ? std::string() : setting.substr(equals + 1);
    std::string place = "/" + setting.substr(0, equals);
    std::replace(place.begin(), place.end(), '.', '/');
    bool is_set = !text.empty() && equals > 0;
    try {
      Json value = Json::parse(text, nullptr, false);
      if (value.is_discarded()) value = text;
      if (is_set) json[Json::json_pointer(place)] = std::move(value);
    } catch (const Json::exception&) {
      // Below a key that holds a value.
      is_set = false;
    }
    if (!is_set) return "'" + setting + "' sets no key; write KEY=VALUE, such as cell.stiffness_ratio=2";
  }
  return std::nullopt;
}

}  // namespace pellucida
