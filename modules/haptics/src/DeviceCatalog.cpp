#include "pellucida/haptics/DeviceCatalog.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "pellucida/core/Error.h"
#include "pellucida/core/FieldJson.h"
#include "pellucida/core/Resources.h"

namespace pellucida {
namespace {

using Json = nlohmann::ordered_json;

FieldList fields_of(DeviceSpecification& device) {
  using D = DeviceSpecification;
  constexpr FieldNeed kRequired = FieldNeed::kRequired;
  constexpr FieldRange kSome{0.0, 1e9};
  static constexpr Field<D> kFields[] = {
      {"name", "", &D::name, {}, "unique, case ignored", kRequired},
      {"max_force_N", "N", &D::max_force_N, kSome, "peak; 0: the device gives no force", kRequired},
      {"max_continuous_force_N", "N", &D::max_continuous_force_N, kSome, "0: not known"},
      {"max_stiffness_N_per_m", "N/m", &D::max_stiffness_N_per_m, kSome, "of a virtual wall that stays stable",
       kRequired},
      {"max_damping_N_s_per_m", "N s/m", &D::max_damping_N_s_per_m, kSome, "the same", kRequired},
      {"physical_damping_N_s_per_m", "N s/m", &D::physical_damping_N_s_per_m, kSome,
       "of the device itself; 0: not known"},
      {"workspace_radius_m", "m", &D::workspace_radius_m, above(0.0, 1e9), "of the hand's way", kRequired},
      {"resolution_m", "m", &D::resolution_m, kSome, "of the position; 0: not known"},
      {"source", "", &D::source, {}, "of the numbers", kRequired},
  };
  return FieldList().add("", kFields, device);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

DeviceSpecification read_device(const Json& device, const std::string& where) {
  if (!device.is_object()) throw InputError(where + ": must be an object with name, limits and source");
  DeviceSpecification read;
  auto fault = read_fields(device, fields_of(read));
  if (!fault) fault = fault_of(read);
  if (fault) throw InputError(where + (read.name.empty() ? "" : " (" + read.name + ")") + ": " + *fault);
  return read;
}

}  // namespace

std::optional<std::string> fault_of(const DeviceSpecification& specification) {
  DeviceSpecification checked = specification;
  if (auto fault = range_fault(fields_of(checked))) return fault;
  const bool gives_force = specification.max_force_N > 0.0;
  if (gives_force && specification.max_stiffness_N_per_m <= 0.0) {
    return "max_stiffness_N_per_m must be above 0 for a device that gives force";
  }
  if (!gives_force && (specification.max_stiffness_N_per_m > 0.0 || specification.max_damping_N_s_per_m > 0.0)) {
    return "max_force_N is 0, so stiffness and damping must be 0 too";
  }
  if (specification.max_continuous_force_N > specification.max_force_N) {
    return "max_continuous_force_N is above max_force_N; one of them is wrong";
  }
  return std::nullopt;
}

std::vector<DeviceSpecification> read_device_catalog(const std::filesystem::path& file) {
  const Json root = read_json_object(file);
  if (root.value("schema", Json()) != "pellucida-haptic-devices") {
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
