#include "pellucida/teleoperation/DeviceSearch.h"

#include <glob.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/MouseHand.h"
#include "pellucida/teleoperation/OpenHapticsHand.h"
#include "pellucida/teleoperation/SerialPort.h"
#include "pellucida/teleoperation/SimulatedInjector.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {
namespace {

/// Input devices this user may not read: what would hide a gamepad that is plugged in.
std::vector<std::string> forbidden_gamepads() {
  std::vector<std::string> forbidden;
  glob_t found{};
  // Gamepads have both a joystick node and an event node; SDL reads the latter.
  if (glob("/dev/input/by-*/*-event-joystick", 0, nullptr, &found) == 0) {
    for (std::size_t i = 0; i < found.gl_pathc; ++i) {
      if (access(found.gl_pathv[i], R_OK) != 0) forbidden.push_back(found.gl_pathv[i]);
    }
  }
  globfree(&found);
  return forbidden;
}

void add_gamepads(std::vector<DeviceReport>& reports) {
  try {
    const auto found = gamepads();
    for (const auto& pad : found) {
      reports.push_back({"hand", "gamepad:" + pad.name, true, pad.has_rumble ? "with rumble" : "without rumble"});
    }
    const auto forbidden = forbidden_gamepads();
    for (const auto& path : forbidden) {
      reports.push_back({"hand", "gamepad", false,
                         "no permission to read " + path +
                             "; add yourself to the group input: sudo adduser \"$USER\" input, and log in again"});
    }
    if (found.empty() && forbidden.empty()) reports.push_back({"hand", "gamepad", false, "none is plugged in"});
  } catch (const DeviceError& error) {
    reports.push_back({"hand", "gamepad", false, error.what()});
  }
}

void add_space_mouse(std::vector<DeviceReport>& reports) {
  const std::string trouble = space_mouse_trouble();
  if (!trouble.empty()) {
    reports.push_back({"hand", "spacemouse", false, trouble});
    return;
  }
  const std::string name = space_mouse_name();
  reports.push_back({"hand", "spacemouse", true, name.empty() ? "the daemon answers without naming its device" : name});
}

void add_open_haptics(std::vector<DeviceReport>& reports) {
  const std::string trouble = open_haptics_trouble();
  reports.push_back({"hand", "openhaptics", trouble.empty(),
                     trouble.empty() ? "the driver's library is present; a device is opened when chosen" : trouble});
}

void add_no_serial_port(const std::string& reason, std::vector<DeviceReport>& reports) {
  reports.push_back({"serial port", "serial port", false, reason});
  reports.push_back({"manipulator", "eppendorf", false, "no serial port; see above"});
}

void add_serial_ports(const std::vector<SerialPortInfo>& ports, std::vector<DeviceReport>& reports) {
  if (ports.empty()) add_no_serial_port("this machine has none; plug in a USB serial adapter", reports);
  for (const auto& port : ports) {
    const bool usable = port.trouble.empty();
    reports.push_back({"serial port", port.path, usable, usable ? port.description : port.trouble});
  }
  for (const auto& port : ports) {
    const bool usable = port.trouble.empty();
    reports.push_back({"manipulator", "eppendorf:" + port.path, usable,
                       usable ? "can be tried; to check for one: pellucida devices --ask " + port.path
                              : "the port can't be used; see above"});
  }
}

}  // namespace

std::vector<DeviceReport> search_cameras(const std::filesystem::path& listing) {
  std::vector<DeviceReport> reports;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(listing, ignored)) {
    const std::string node = entry.path().filename().string();
    if (node.rfind("video", 0) != 0) continue;
    std::string model;
    std::getline(std::ifstream(entry.path() / "name"), model);
    const bool allowed = access(("/dev/" + node).c_str(), R_OK | W_OK) == 0;
    reports.push_back({"camera", "v4l2:" + node.substr(5), allowed,
                       allowed
                           ? model
                           : "no permission to read and write /dev/" + node +
                                 "; add yourself to the group video: sudo adduser \"$USER\" video, and log in again"});
  }
  std::sort(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  if (reports.empty())
    reports.push_back({"camera", "v4l2", false, "no Video4Linux camera is plugged in (no /dev/video*)"});
  return reports;
}

std::vector<DeviceReport> search_hand_devices() {
  std::vector<DeviceReport> reports;
  add_open_haptics(reports);
  add_space_mouse(reports);
  add_gamepads(reports);
  reports.push_back({"hand", "mouse", true, "mouse and keyboard; no force, the resistance is seen"});
  return reports;
}

std::vector<DeviceReport> search_manipulators() {
  std::vector<DeviceReport> reports;
  try {
    add_serial_ports(serial_ports(), reports);
  } catch (const DeviceError& error) {
    add_no_serial_port(error.what(), reports);
  }
  reports.push_back({"manipulator", "simulated", true, "the simulated injector"});
  return reports;
}

}  // namespace pellucida
