#include "pellucida/teleoperation/DeviceChoice.h"

#include <string_view>
#include <utility>

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/EppendorfManipulator.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/MouseHand.h"
#include "pellucida/teleoperation/OpenHapticsHand.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {
namespace {

/// "gamepad:Xbox" is a kind and what follows the colon.
std::pair<std::string, std::string> split(const std::string& name) {
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos) return {name, {}};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

template <class Device>
ChosenHand springing_back(std::unique_ptr<Device> device) {
  ChosenHand hand;
  hand.cue = device.get();
  hand.settings.control = TeleoperationSettings::Control::kRate;
  hand.settings.self_centring = true;
  hand.device = std::move(device);
  return hand;
}

}  // namespace

ChosenHand open_hand_device(const std::string& name) {
  const auto [kind, rest] = split(name);
  if (kind == "gamepad") {
    GamepadOptions options;
    options.name = rest;
    return springing_back(std::make_unique<GamepadHand>(options));
  }
  if (name == "spacemouse") return springing_back(std::make_unique<SpaceMouseHand>());
  ChosenHand hand;
  hand.tremor.enabled = false;
  if (name == "mouse") {
    auto mouse = std::make_unique<MouseHand>();
    hand.mouse = mouse.get();
    hand.cue = mouse.get();
    hand.device = std::move(mouse);
    return hand;
  }
  if (kind == "openhaptics") {
    OpenHapticsOptions options;
    options.device = rest;
    hand.device = std::make_unique<OpenHapticsHand>(options);
    return hand;
  }
  throw UsageError("no device for the hand is called \"" + name +
                   "\"; take mouse, gamepad, gamepad:NAME, spacemouse, openhaptics or openhaptics:NAME; pellucida "
                   "devices lists what is there");
}

std::unique_ptr<Manipulator> make_manipulator(const std::string& name, const SimulatedInjectorOptions& simulated,
                                              SimulatedInjector::Follower follower) {
  const auto [kind, rest] = split(name);
  if (name == "simulated") return std::make_unique<SimulatedInjector>(simulated, std::move(follower));
  if (kind == "eppendorf" && !rest.empty()) {
    EppendorfOptions options;
    options.port = rest;
    return std::make_unique<EppendorfManipulator>(options);
  }
  throw UsageError(
      "no manipulator is called \"" + name +
      "\"; take simulated or eppendorf:PORT, such as eppendorf:/dev/ttyUSB0; pellucida devices lists the ports");
}

}  // namespace pellucida
