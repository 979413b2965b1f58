// In place of GamepadHand.cpp where SDL was left out of the build (PELLUCIDA_WITH_SDL2=OFF).
#include "NotInThisBuild.h"
#include "pellucida/core/Error.h"
#include "pellucida/teleoperation/GamepadHand.h"

namespace pellucida {
namespace {

[[noreturn]] void refuse() {
  throw DeviceError("gamepad: " + not_in_this_build("gamepad", "SDL 2", "PELLUCIDA_WITH_SDL2", "libsdl2-dev"));
}

}  // namespace

std::vector<GamepadInfo> gamepads() {
  refuse();
}

std::string gamepad_library_version() {
  return {};
}

struct GamepadHand::Sdl {};

GamepadHand::GamepadHand(const GamepadOptions& options) : PolledHand(DeviceSpecification{}), options_(options) {
  refuse();
}

GamepadHand::~GamepadHand() = default;

PolledHand::Reading GamepadHand::poll(const TouchCue&, std::stop_token) {
  return {};
}

}  // namespace pellucida
