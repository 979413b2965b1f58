#pragma once
#include <memory>
#include <string>

#include "pellucida/haptics/HapticDevice.h"
#include "pellucida/teleoperation/Manipulator.h"
#include "pellucida/teleoperation/SimulatedInjector.h"
#include "pellucida/teleoperation/TeleoperationMap.h"
#include "pellucida/teleoperation/TouchCue.h"

namespace pellucida {

class MouseHand;

/// An open input device with suitable settings.
struct ChosenHand {
  std::unique_ptr<HapticDevice> device;
  TouchCueDevice* cue = nullptr;  ///< the same device, if it shows the contact in its own way
  MouseHand* mouse = nullptr;     ///< the same device, if a window has to feed it
  TeleoperationSettings settings;
  TremorOptions tremor;
};

/// Opens a device by the name `pellucida devices` lists: `mouse`, `gamepad[:PART OF ITS NAME]`, `spacemouse`,
/// `openhaptics[:NAME IN THE DRIVER'S SETUP]`. Devices that spring back come with rate control. The tremor low-pass is
/// off for a mouse, which rests on the table, and for devices that give force, whose contact its lag would soften.
/// Throws UsageError for an unknown name, DeviceError as the device.
ChosenHand open_hand_device(const std::string& name);

/// A manipulator by its name, not yet open: `simulated` (with these options and follower), or `eppendorf:PORT`. Throws
/// UsageError for an unknown name.
std::unique_ptr<Manipulator> make_manipulator(const std::string& name, const SimulatedInjectorOptions& simulated = {},
                                              SimulatedInjector::Follower follower = {});

}  // namespace pellucida
