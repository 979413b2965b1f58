// In place of SpaceMouseHand.cpp where libspnav was left out of the build (PELLUCIDA_WITH_SPNAV=OFF).
#include "NotInThisBuild.h"
#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/SpaceMouseHand.h"

namespace pellucida {

std::string space_mouse_trouble() {
  return not_in_this_build("SpaceMouse", "libspnav", "PELLUCIDA_WITH_SPNAV", "libspnav-dev");
}

std::string space_mouse_name() {
  return {};
}

std::string space_mouse_library_version() {
  return {};
}

SpaceMouseHand::SpaceMouseHand(const SpaceMouseOptions& options)
    : PolledHand(DeviceSpecification{}), options_(options) {
  throw DeviceError("SpaceMouse: " + space_mouse_trouble());
}

SpaceMouseHand::~SpaceMouseHand() = default;

PolledHand::Reading SpaceMouseHand::poll(const TouchCue&, std::stop_token) {
  return {};
}

}  // namespace pellucida
