#include "pellucida/haptics/DeviceCatalog.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "pellucida/core/Error.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

// A number of the specification: key, place, whether it must be in the file.
struct Field {
  const char* key;
  double DeviceSpecification::*place;
  bool required;
};
constexpr Field kFields[] = {
    {"max_force_N", &DeviceSpecification::max_force_N, true},
    {"max_continuous_force_N", &DeviceSpecification::max_continuous_force_N, false},
    {"max_stiffness_N_per_m", &DeviceSpecification::max_stiffness_N_per_m, true},
    {"max_damping_N_s_per_m", &DeviceSpecification::max_damping_N_s_per_m, true},
    {"physical_damping_N_s_per_m", &DeviceSpecification::physical_damping_N_s_per_m, false},
    {"workspace_radius_m", &DeviceSpecification::workspace_radius_m, true},
    {"resolution_m", &DeviceSpecification::resolution_m, false},
};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

std::string text_of(const Json& device, const char* key, const std::string& where) {
  if (!device.contains(key) || !device[key].is_string() || device[key].get<std::string>().empty()) {
    throw InputError(where + ": \"" + key + "\" must be a text; add it");
  }
  return device[key].get<std::string>();
}

DeviceSpecification read_device(const Json& device, const std::string& where) {
  if (!device.is_object()) throw InputError(where + ": must be an object with name, limits and source");
  DeviceSpecification read;
  read.name = text_of(device, "name", where);
  const std::string named = where + " (" + read.name + ")";
  read.source = text_of(device, "source", named);
  for (const auto& item : device.items()) {
    const std::string& key = item.key();
    const bool known =
        key == "name" || key == "source" ||
        std::any_of(std::begin(kFields), std::end(kFields), [&](const Field& f) { return key == f.key; });
    if (!known) throw InputError(named + ": \"" + key + "\" is no property of a device; correct its spelling");
  }
  for (const Field& field : kFields) {
    if (!device.contains(field.key)) {
      if (field.required) throw InputError(named + ": \"" + field.key + "\" is missing; add it");
      continue;
    }
    if (!device[field.key].is_number()) throw InputError(named + ": \"" + field.key + "\" must be a number");
    read.*field.place = device[field.key].get<double>();
  }
  if (const auto fault = fault_of(read)) throw InputError(named + ": " + *fault);
  return read;
}

}  // namespace

std::optional<std::string> fault_of(const DeviceSpecification& specification) {
  for (const Field& field : kFields) {
    const double value = specification.*field.place;
    if (!(value >= 0.0) || !std::isfinite(value)) {
      return std::string("\"").append(field.key).append("\" is ").append(Json(value).dump()) +
             "; it must be 0 or above";
    }
  }
  if (specification.workspace_radius_m <= 0.0) return "\"workspace_radius_m\" must be above 0";
  const bool gives_force = specification.max_force_N > 0.0;
  if (gives_force && specification.max_stiffness_N_per_m <= 0.0) {
    return "\"max_stiffness_N_per_m\" must be above 0 for a device that gives force";
  }
  if (!gives_force && (specification.max_stiffness_N_per_m > 0.0 || specification.max_damping_N_s_per_m > 0.0)) {
    return "\"max_force_N\" is 0, so stiffness and damping must be 0 too";
  }
  if (specification.max_continuous_force_N > specification.max_force_N) {
    return "\"max_continuous_force_N\" is above \"max_force_N\"; one of them is wrong";
  }
  return std::nullopt;
}

std::vector<DeviceSpecification> read_device_catalog(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string() + ": the device list can't be read; check the path and its permissions");
  Json root;
  try {
    root = Json::parse(stream);
  } catch (const Json::parse_error& error) {
    throw InputError(file.string() + ": no JSON at byte " + std::to_string(error.byte) + "; correct the file");
  }
  if (!root.is_object() || root.value("schema", Json()) != "pellucida-haptic-devices") {
    throw InputError(file.string() + ": \"schema\" must be \"pellucida-haptic-devices\"");
  }
  if (root.value("schema_version", Json()) != 1) {
    throw InputError(file.string() + ": \"schema_version\" must be 1; update the program or the file");
  }
  if (!root.contains("devices") || !root["devices"].is_array() || root["devices"].empty()) {
    throw InputError(file.string() + ": \"devices\" must be a list with at least one device");
  }
  std::vector<DeviceSpecification> devices;
  std::set<std::string> names;
  for (const Json& device : root["devices"]) {
    devices.push_back(read_device(device, file.string() + ": devices[" + std::to_string(devices.size()) + "]"));
    if (!names.insert(lower_case(devices.back().name)).second) {
      throw InputError(file.string() + ": the device \"" + devices.back().name + "\" is listed twice; remove one");
    }
  }
  return devices;
}

std::vector<DeviceSpecification> shipped_devices() {
  return read_device_catalog(resource_folder() / "devices" / "haptic-devices.json");
}

DeviceSpecification find_device(std::string_view name) {
  std::string known;
  for (DeviceSpecification& device : shipped_devices()) {
    if (lower_case(device.name) == lower_case(name)) return std::move(device);
    known += (known.empty() ? "" : ", ") + device.name;
  }
  throw UsageError("no haptic device \"" + std::string(name) + "\"; known: " + known);
}

}  // namespace pellucida
