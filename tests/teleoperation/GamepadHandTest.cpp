#include "pellucida/teleoperation/GamepadHand.h"

#include <SDL.h>
#include <gtest/gtest.h>

#include <atomic>

#include "pellucida/core/Error.h"
#include "teleoperation/Eventually.h"

namespace pellucida {
namespace {

constexpr const char* kName = "Pellucida test pad";
std::atomic<int> rumble{-1};

int SDLCALL note_rumble(void*, Uint16 low, Uint16) {
  rumble = low;
  return 0;
}

/// A gamepad of SDL's own making.
class VirtualPad {
 public:
  explicit VirtualPad(bool with_rumble = true) {
    SDL_VirtualJoystickDesc description{};
    description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    description.naxes = SDL_CONTROLLER_AXIS_MAX;
    description.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    description.name = kName;
    if (with_rumble) description.Rumble = note_rumble;
    index_ = SDL_JoystickAttachVirtualEx(&description);
    joystick_ = SDL_JoystickOpen(index_);
  }
  ~VirtualPad() {
    if (joystick_) unplug();
  }
  void axis(int number, int value) { SDL_JoystickSetVirtualAxis(joystick_, number, static_cast<Sint16>(value)); }
  void button(int number, bool down) { SDL_JoystickSetVirtualButton(joystick_, number, down ? 1 : 0); }
  void unplug() {
    for (int index = 0; index < SDL_NumJoysticks(); ++index) {
      if (SDL_JoystickGetDeviceInstanceID(index) == SDL_JoystickInstanceID(joystick_)) {
        SDL_JoystickDetachVirtual(index);
        break;
      }
    }
    SDL_JoystickClose(joystick_);
    joystick_ = nullptr;
  }
  bool valid() const { return joystick_ != nullptr; }

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

class GamepadHandTest : public testing::Test {
 protected:
  GamepadHandTest() {
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
    options_.name = kName;
    rumble = -1;
  }
  ~GamepadHandTest() override { SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER); }

  /// The newest reading, taken as the 1 kHz thread would.
  bool read() { return hand_->read(time_s_ += 0.001, sample_); }

  GamepadOptions options_;
  std::unique_ptr<GamepadHand> hand_;
  HandSample sample_;
  double time_s_ = 0.0;
};

TEST_F(GamepadHandTest, SaysThatNoneIsThere) {
  try {
    GamepadHand hand(options_);
    FAIL() << "opened a gamepad that is not there";
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("gamepad: none"), std::string::npos) << error.what();
  }
}

TEST_F(GamepadHandTest, ListsWhatIsThere) {
  VirtualPad pad;
  ASSERT_TRUE(pad.valid()) << SDL_GetError();
  bool found = false;
  for (const auto& info : gamepads()) found |= info.name == kName && info.has_rumble;
  EXPECT_TRUE(found);
  options_.name = "no such pad";
  try {
    GamepadHand hand(options_);
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find(kName), std::string::npos) << error.what();
  }
}

TEST_F(GamepadHandTest, SticksMoveTheHandInItsFrame) {
  VirtualPad pad;
  hand_ = std::make_unique<GamepadHand>(options_);
  pad.axis(SDL_CONTROLLER_AXIS_LEFTX, 32767);
  pad.axis(SDL_CONTROLLER_AXIS_LEFTY, -32767);
  pad.axis(SDL_CONTROLLER_AXIS_RIGHTY, 16384);
  eventually([&] { return read() && sample_.position_m.z > 0.0099999; });
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(read());
  EXPECT_NEAR(sample_.position_m.x, 0.02, 1e-6);
  EXPECT_NEAR(sample_.position_m.y, 0.02, 1e-6);
  EXPECT_NEAR(sample_.position_m.z, 0.01, 1e-5);
  EXPECT_EQ(hand_->specification().max_force_N, 0.0);
}

TEST_F(GamepadHandTest, ButtonsMeanWhatTheyShould) {
  VirtualPad pad;
  hand_ = std::make_unique<GamepadHand>(options_);
  const std::pair<int, std::uint32_t> meanings[] = {{SDL_CONTROLLER_BUTTON_A, kInject},
                                                    {SDL_CONTROLLER_BUTTON_B, kClutch},
                                                    {SDL_CONTROLLER_BUTTON_X, kRetract},
                                                    {SDL_CONTROLLER_BUTTON_Y, kEmergency},
                                                    {SDL_CONTROLLER_BUTTON_BACK, kEmergency}};
  for (const auto& [button, meaning] : meanings) {
    pad.button(button, true);
    eventually([&, expected = meaning] { return read() && sample_.buttons == expected; });
    pad.button(button, false);
    eventually([&] { return read() && sample_.buttons == 0; });
  }
}

TEST_F(GamepadHandTest, RumblesWithTheContact) {
  VirtualPad pad;
  hand_ = std::make_unique<GamepadHand>(options_);
  TouchCue cue;
  cue.contact = true;
  cue.force_N = {0.0, 1.0, 0.0};
  hand_->show(cue);
  eventually([] { return rumble == 32768; });
  cue.force_N = {0.0, 9.0, 0.0};
  hand_->show(cue);
  eventually([] { return rumble == 65535; });
  hand_->show({});
  eventually([] { return rumble == 0; });
}

TEST_F(GamepadHandTest, IsLostWhenUnpluggedAndComesBack) {
  VirtualPad pad(false);
  hand_ = std::make_unique<GamepadHand>(options_);
  eventually([&] { return read(); });
  pad.button(SDL_CONTROLLER_BUTTON_A, true);
  eventually([&] { return read() && sample_.buttons == kInject; });
  pad.unplug();
  eventually([&] { return !read(); });
  EXPECT_EQ(sample_.buttons, 0u);
  EXPECT_FALSE(hand_->write({}));
  VirtualPad again;
  eventually([&] { return read(); });
  EXPECT_TRUE(hand_->write({}));
}

TEST_F(GamepadHandTest, AThreadThatFallsSilentIsALostDevice) {
  VirtualPad pad;
  hand_ = std::make_unique<GamepadHand>(options_);
  eventually([&] { return read() && hand_->reading_count() > 2; });
  // A jump of the clock simulates a second without a reading.
  hand_->read(time_s_, sample_);
  bool silent_seen = false;
  for (int i = 0; i < 1000 && !silent_seen; ++i) {
    hand_->read(time_s_ += 1.0, sample_);
    silent_seen = !hand_->read(time_s_ += 1.0, sample_);
  }
  EXPECT_TRUE(silent_seen);
}

TEST_F(GamepadHandTest, RefusesOptionsThatMeanNothing) {
  options_.rate_Hz = 0.0;
  EXPECT_THROW(GamepadHand hand(options_), UsageError);
}

}  // namespace
}  // namespace pellucida
