#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pellucida/haptics/HapticDevice.h"

namespace pellucida {

/// The fault of a specification, as "key is value; ..." ; nothing when it can be used. A device without force
/// (`max_force_N` 0) must have no stiffness and no damping; one with force needs both limits.
std::optional<std::string> fault_of(const DeviceSpecification& specification);

/// The devices of a JSON file of schema `pellucida-haptic-devices`, in its order. Keys are the fields of
/// `DeviceSpecification`; `name`, `max_force_N`, `max_stiffness_N_per_m`, `max_damping_N_s_per_m`, `workspace_radius_m`
/// and `source` are required, the others default to 0 (not known). Throws InputError naming file, device and key.
std::vector<DeviceSpecification> read_device_catalog(const std::filesystem::path& file);

/// The shipped list, `resources/devices/haptic-devices.json`.
std::vector<DeviceSpecification> shipped_devices();

/// The shipped device of that name, ignoring case. Throws UsageError that lists the names known.
DeviceSpecification find_device(std::string_view name);

}  // namespace pellucida
