#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/DeviceChoice.h"
#include "pellucida/teleoperation/DeviceSearch.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/SerialPort.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

// What a build says whose devices' libraries were left out: this program holds their stand-ins, the sources
// ...Absent.cpp.

namespace pellucida {
namespace {

/// One entry per device whose library can be left out: its name, how it is chosen, and the build's option for it.
struct AbsentDevice {
  const char* name;
  const char* choice;
  const char* option;
  const char* package;
};
constexpr AbsentDevice kHands[] = {{"gamepad", "gamepad", "-DPELLUCIDA_WITH_SDL2=ON", "libsdl2-dev"},
                                   {"spacemouse", "spacemouse", "-DPELLUCIDA_WITH_SPNAV=ON", "libspnav-dev"}};
constexpr AbsentDevice kSerialPort = {"serial port", "eppendorf:/dev/ttyS0", "-DPELLUCIDA_WITH_SERIALPORT=ON",
                                      "libserialport-dev"};

void expect_explained(const std::string& text, const AbsentDevice& device) {
  for (const char* part : {"this build has no", device.option, device.package}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

void expect_reported(const std::vector<DeviceReport>& reports, const AbsentDevice& device) {
  const auto report = std::find_if(reports.begin(), reports.end(),
                                   [&](const DeviceReport& candidate) { return candidate.name == device.name; });
  ASSERT_NE(report, reports.end()) << device.name;
  EXPECT_FALSE(report->usable) << device.name;
  expect_explained(report->detail, device);
}

TEST(AbsentDevices, TheSearchSaysWhatTheBuildLacksAndListsTheRest) {
  const auto hands = search_hand_devices();
  for (const AbsentDevice& device : kHands) expect_reported(hands, device);
  EXPECT_TRUE(hands.back().usable) << "the mouse needs no library";

  const auto manipulators = search_manipulators();
  expect_reported(manipulators, kSerialPort);
  EXPECT_EQ(manipulators.back().name, "simulated");
  EXPECT_TRUE(manipulators.back().usable);
}

TEST(AbsentDevices, AskingForOneIsAMissingDevice) {
  for (const AbsentDevice& device : kHands) {
    try {
      open_hand_device(device.choice);
      FAIL() << device.name << " was opened";
    } catch (const DeviceError& error) {
      expect_explained(error.what(), device);
    }
  }
  const auto manipulator = make_manipulator(kSerialPort.choice);
  try {
    manipulator->open();
    FAIL() << "a manipulator was opened";
  } catch (const DeviceError& error) {
    expect_explained(error.what(), kSerialPort);
  }
  EXPECT_FALSE(manipulator->is_open());
}

TEST(AbsentDevices, NoLibraryHasNoVersion) {
  EXPECT_TRUE(gamepad_library_version().empty());
  EXPECT_TRUE(space_mouse_library_version().empty());
  EXPECT_TRUE(serial_port_library_version().empty());
}

}  // namespace
}  // namespace pellucida
