#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace pellucida {

/// A device, or a kind of device, and whether it can be used now.
struct DeviceReport {
  std::string kind;  ///< "hand", "manipulator", "serial port", "camera"
  std::string name;  ///< the name by which it is chosen
  bool usable = false;
  std::string detail;  ///< usable: what it is; otherwise why not, and how to correct it
};

/// Video4Linux's cameras, by the names a source takes (`v4l2:N`). No camera is one report that says so. `listing`: the
/// system's folder of them.
std::vector<DeviceReport> search_cameras(const std::filesystem::path& listing = "/sys/class/video4linux");

/// The input devices: OpenHaptics, SpaceMouse, gamepads, mouse and keyboard. A missing kind is one report that states
/// why. Moves nothing, opens nothing for longer than the search takes.
std::vector<DeviceReport> search_hand_devices();

/// Serial ports, and what may drive a pipette: over a port, or simulated. A manipulator is not queried over the line,
/// since a command sent to an unknown device may move it.
std::vector<DeviceReport> search_manipulators();

}  // namespace pellucida
