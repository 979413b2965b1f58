#include "pellucida/teleoperation/GamepadHand.h"

#include <SDL.h>

#include <algorithm>
#include <cmath>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr double kLookAgain_s = 0.5;
constexpr double kRumbleRenewed_s = 0.05;
constexpr Uint32 kRumbleLasts_ms = 200;  // a program that dies does not leave it rumbling
constexpr double kFullAxis = 32767.0;

/// SDL's joystick part, in use while this lives. SDL counts the users itself.
struct SdlInUse {
  SdlInUse() {
    // Without a window of SDL's own nothing counts as in the foreground; signals belong to the program.
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0) {
      throw DeviceError(std::string("gamepad: SDL can't search for gamepads (") + SDL_GetError() + ")");
    }
  }
  ~SdlInUse() { SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER); }
  SdlInUse(const SdlInUse&) = delete;
  SdlInUse& operator=(const SdlInUse&) = delete;
};

const char* name_of(int index) {
  const char* name = SDL_JoystickNameForIndex(index);
  return name ? name : "unnamed";
}

DeviceSpecification specification_for(const GamepadOptions& options) {
  for (const double value : {options.reach_m, options.rate_Hz, options.full_rumble_N}) {
    if (value > 0.0 && std::isfinite(value)) continue;
    throw UsageError("gamepad: reach, rate and force must be above 0, not " + std::to_string(value));
  }
  DeviceSpecification specification;
  specification.name = "gamepad";
  specification.workspace_radius_m = options.reach_m;
  specification.resolution_m = options.reach_m / kFullAxis;
  specification.source = "chosen";
  return specification;
}

/// Axes and buttons by what they mean, for pads SDL knows and for plain joysticks.
struct Pad {
  explicit Pad(SDL_Joystick* joystick) : joystick_(joystick) {
    controller_ = SDL_GameControllerFromInstanceID(SDL_JoystickInstanceID(joystick));
  }
  double axis(SDL_GameControllerAxis known, int plain) const {
    const Sint16 value =
        controller_ ? SDL_GameControllerGetAxis(controller_, known) : SDL_JoystickGetAxis(joystick_, plain);
    return std::clamp(value / kFullAxis, -1.0, 1.0);
  }
  bool button(SDL_GameControllerButton known, int plain) const {
    return (controller_ ? SDL_GameControllerGetButton(controller_, known) : SDL_JoystickGetButton(joystick_, plain)) !=
           0;
  }

 private:
  SDL_Joystick* joystick_;
  SDL_GameController* controller_;
};

}  // namespace

std::vector<GamepadInfo> gamepads() {
  const SdlInUse sdl;
  SDL_JoystickUpdate();
  std::vector<GamepadInfo> found;
  for (int index = 0; index < SDL_NumJoysticks(); ++index) {
    GamepadInfo info{index, name_of(index), false};
    if (SDL_Joystick* joystick = SDL_JoystickOpen(index)) {
      info.has_rumble = SDL_JoystickHasRumble(joystick) == SDL_TRUE;
      SDL_JoystickClose(joystick);
    }
    found.push_back(info);
  }
  return found;
}

std::string gamepad_library_version() {
  SDL_version version;
  SDL_GetVersion(&version);
  return std::to_string(version.major) + '.' + std::to_string(version.minor) + '.' + std::to_string(version.patch);
}

struct GamepadHand::Sdl : SdlInUse {
  SDL_Joystick* joystick = nullptr;
  SDL_GameController* controller = nullptr;
};

GamepadHand::GamepadHand(const GamepadOptions& options)
    : PolledHand(specification_for(options)), options_(options), sdl_(std::make_unique<Sdl>()) {
  SDL_JoystickUpdate();
  if (!look_for_it()) {
    std::string there;
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
      there += std::string(there.empty() ? "" : ", ") + "\"" + name_of(index) + "\"";
    }
    if (there.empty()) throw DeviceError("gamepad: none is plugged in");
    throw DeviceError("gamepad: none has \"" + options.name + "\" in its name; there is " + there);
  }
  start();
}

GamepadHand::~GamepadHand() {
  stop();
  release();
}

void GamepadHand::release() {
  if (sdl_->controller) SDL_GameControllerClose(sdl_->controller);
  if (sdl_->joystick) SDL_JoystickClose(sdl_->joystick);
  sdl_->controller = nullptr;
  sdl_->joystick = nullptr;
}

bool GamepadHand::look_for_it() {
  for (int index = 0; index < SDL_NumJoysticks(); ++index) {
    if (std::string(name_of(index)).find(options_.name) == std::string::npos) continue;
    sdl_->joystick = SDL_JoystickOpen(index);
    if (!sdl_->joystick) continue;
    if (SDL_IsGameController(index)) sdl_->controller = SDL_GameControllerOpen(index);
    last_rumble_ = until_next_rumble_ = 0;
    return true;
  }
  return false;
}

PolledHand::Reading GamepadHand::poll(const TouchCue& cue, std::stop_token stop) {
  wait_for(stop, 1.0 / options_.rate_Hz);
  SDL_JoystickUpdate();
  if (sdl_->joystick && !SDL_JoystickGetAttached(sdl_->joystick)) {
    release();
    until_next_look_ = 0;
  }
  if (!sdl_->joystick) {
    if (until_next_look_-- > 0 || !look_for_it()) {
      if (until_next_look_ < 0) until_next_look_ = static_cast<int>(kLookAgain_s * options_.rate_Hz);
      return {};
    }
  }
  const Pad pad(sdl_->joystick);
  Reading reading;
  reading.connected = true;
  // SDL counts down and towards the person as above 0.
  reading.position_m = {options_.reach_m * pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 0),
                        -options_.reach_m * pad.axis(SDL_CONTROLLER_AXIS_LEFTY, 1),
                        options_.reach_m * pad.axis(SDL_CONTROLLER_AXIS_RIGHTY, 3)};
  if (pad.button(SDL_CONTROLLER_BUTTON_A, 0)) reading.buttons |= kInject;
  if (pad.button(SDL_CONTROLLER_BUTTON_B, 1)) reading.buttons |= kClutch;
  if (pad.button(SDL_CONTROLLER_BUTTON_X, 2)) reading.buttons |= kRetract;
  if (pad.button(SDL_CONTROLLER_BUTTON_Y, 3) || pad.button(SDL_CONTROLLER_BUTTON_BACK, 4))
    reading.buttons |= kEmergency;
  rumble(cue);
  return reading;
}

void GamepadHand::rumble(const TouchCue& cue) {
  const double share = cue.contact ? std::min(cue.force_N.eigen().norm() / options_.full_rumble_N, 1.0) : 0.0;
  const int strength = static_cast<int>(std::lround(share * 65535.0));
  if (--until_next_rumble_ > 0 || (strength == 0 && last_rumble_ == 0)) return;
  until_next_rumble_ = std::max(1, static_cast<int>(kRumbleRenewed_s * options_.rate_Hz));
  last_rumble_ = strength;
  // A pad without rumble says so each time; that is no fault.
  SDL_JoystickRumble(sdl_->joystick, static_cast<Uint16>(strength), static_cast<Uint16>(strength), kRumbleLasts_ms);
}

}  // namespace pellucida
