#pragma once
#include <string>
#include <vector>

namespace pellucida {

/// A device, or a kind of device, and whether it can be used now.
struct DeviceReport {
  std::string kind;  ///< "hand", "manipulator", "serial port", "camera"
  std::string name;  ///< how it is called where it can be chosen
  bool usable = false;
  std::string detail;  ///< usable: what it is; else exactly why not, and how to mend it
};

/// The devices for the hand: OpenHaptics, SpaceMouse, gamepads, mouse and keyboard. A kind of which there is none is
/// one report that says why. Moves nothing, opens nothing for longer than the look takes.
std::vector<DeviceReport> search_hand_devices();

/// Serial ports, and what may drive a pipette: over a port, or simulated. A manipulator is not asked over the line,
/// since a command sent to an unknown device may move it.
std::vector<DeviceReport> search_manipulators();

}  // namespace pellucida
