#pragma once
#include <memory>
#include <string>
#include <vector>

#include "pellucida/teleoperation/PolledHand.h"

namespace pellucida {

/// A gamepad or joystick of this machine.
struct GamepadInfo {
  int index = 0;  ///< as SDL counts them now
  std::string name;
  bool has_rumble = false;
};

/// The gamepads there are. Throws DeviceError when SDL can't look for them, or isn't in this build.
std::vector<GamepadInfo> gamepads();

/// The version of the SDL in use; empty in a build without it (PELLUCIDA_WITH_SDL2).
std::string gamepad_library_version();

struct GamepadOptions {
  std::string name;            ///< part of its name; empty: the first one
  double reach_m = 0.02;       ///< hand motion for a fully deflected stick
  double rate_Hz = 250.0;      ///< readings a second
  double full_rumble_N = 2.0;  ///< force of the strongest rumble
};

/// A gamepad through SDL 2. Left stick: the image plane; right stick, up and down: along the depth (pulled is towards
/// the person). It springs back: use rate control with `self_centring`. Buttons, in SDL's layout: A injects, B is the
/// clutch, X retracts, Y or Back is the emergency stop. The contact is shown by its rumble, if it has one.
///
/// When unplugged it is lost; when plugged in again (or another one that matches the name), it is back.
class GamepadHand final : public PolledHand {
 public:
  /// Throws DeviceError: none present, or none of that name (and which are present), or no SDL in this build;
  /// UsageError for a number not above 0.
  explicit GamepadHand(const GamepadOptions& options = {});
  ~GamepadHand() override;

 private:
  struct Sdl;
  Reading poll(const TouchCue& cue, std::stop_token stop) override;
  bool look_for_it();
  void release();
  void rumble(const TouchCue& cue);

  GamepadOptions options_;
  std::unique_ptr<Sdl> sdl_;  ///< all that is SDL's
  int last_rumble_ = 0;
  int until_next_rumble_ = 0;  ///< polls
  int until_next_look_ = 0;    ///< polls
};

}  // namespace pellucida
