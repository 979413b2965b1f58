#pragma once
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

/// The input devices: OpenHaptics, SpaceMouse, gamepads, mouse and keyboard. A missing kind is one report that states
/// why. Moves nothing, opens nothing for longer than the search takes.
std::vector<DeviceReport> search_hand_devices();

/// Serial ports, and what may drive a pipette: over a port, or simulated. A manipulator is not queried over the line,
/// since a command sent to an unknown device may move it.
std::vector<DeviceReport> search_manipulators();

}  // namespace pellucida
