#include "HandCatalog.h"

#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/GamepadHand.h"
#include "pellucida/teleoperation/MouseHand.h"
#include "pellucida/teleoperation/OpenHapticsHand.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {

HandCatalog::HandCatalog(bool demonstration) {
  if (demonstration) add("Demonstration", {});
  add("Mouse and keyboard", {[] { return std::make_unique<MouseHand>(); }});
  find_devices();
}

void HandCatalog::add(std::string name, Choice choice) {
  names_.push_back(std::move(name));
  choices_.push_back(std::move(choice));
}

void HandCatalog::find_devices() {
  if (open_haptics_trouble().empty()) {
    add("OpenHaptics device", {[] { return std::make_unique<OpenHapticsHand>(); }});
  }
  if (space_mouse_trouble().empty()) add("SpaceMouse", {[] { return std::make_unique<SpaceMouseHand>(); }, true});
  try {
    for (const GamepadInfo& pad : gamepads()) {
      add(pad.name, {[name = pad.name] { return std::make_unique<GamepadHand>(GamepadOptions{.name = name}); }, true});
    }
  } catch (const DeviceError&) {
    // No gamepad can be chosen; `pellucida devices` says why.
  }
}

std::optional<int> HandCatalog::find(std::string_view start) const noexcept {
  for (std::size_t k = 0; k < names_.size(); ++k) {
    if (std::string_view(names_[k]).starts_with(start)) return static_cast<int>(k);
  }
  return std::nullopt;
}

}  // namespace pellucida
