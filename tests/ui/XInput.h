#pragma once
#include <xcb/xcb.h>
#include <xcb/xtest.h>

#include <cstdint>
#include <cstdlib>

namespace pellucida::test {

/// A keyboard and a mouse for the X server that DISPLAY names: what they do reaches the programs as a person's would.
class XInput {
 public:
  XInput() : server_(xcb_connect(nullptr, nullptr)) {
    root_ = xcb_setup_roots_iterator(xcb_get_setup(server_)).data->root;
  }
  ~XInput() { xcb_disconnect(server_); }
  XInput(const XInput&) = delete;
  XInput& operator=(const XInput&) = delete;

  /// By keysym, the X server's name of what a key bears.
  void key(std::uint32_t keysym, bool down) { send(down ? XCB_KEY_PRESS : XCB_KEY_RELEASE, code_of(keysym)); }
  void tap(std::uint32_t keysym) {
    key(keysym, true);
    key(keysym, false);
  }
  /// Pixels of the screen.
  void move(int x, int y) {
    xcb_test_fake_input(server_, XCB_MOTION_NOTIFY, 0, XCB_CURRENT_TIME, root_, static_cast<std::int16_t>(x),
                        static_cast<std::int16_t>(y), 0);
    xcb_flush(server_);
  }
  void left_button(bool down) { send(down ? XCB_BUTTON_PRESS : XCB_BUTTON_RELEASE, 1); }

 private:
  void send(std::uint8_t kind, std::uint8_t detail) {
    xcb_test_fake_input(server_, kind, detail, XCB_CURRENT_TIME, XCB_NONE, 0, 0, 0);
    xcb_flush(server_);
  }

  std::uint8_t code_of(std::uint32_t keysym) const {
    const auto* setup = xcb_get_setup(server_);
    const auto count = static_cast<std::uint8_t>(setup->max_keycode - setup->min_keycode + 1);
    auto* keys =
        xcb_get_keyboard_mapping_reply(server_, xcb_get_keyboard_mapping(server_, setup->min_keycode, count), nullptr);
    const xcb_keysym_t* symbols = xcb_get_keyboard_mapping_keysyms(keys);
    std::uint8_t code = 0;
    for (unsigned k = 0; k < count && code == 0; ++k) {
      if (symbols[k * keys->keysyms_per_keycode] == keysym) code = static_cast<std::uint8_t>(setup->min_keycode + k);
    }
    std::free(keys);
    return code;
  }

  xcb_connection_t* server_;
  xcb_window_t root_;
};

inline constexpr std::uint32_t kEscapeKey = 0xff1b, kShiftKey = 0xffe1, kHomeKey = 0xff50, kVKey = 0x76, kPKey = 0x70,
                               kEndKey = 0xff57, kLeftKey = 0xff51, kRightKey = 0xff53, kPageUpKey = 0xff55,
                               kPageDownKey = 0xff56, kSpaceKey = 0x20, kLKey = 0x6c, kBKey = 0x62, kCKey = 0x63,
                               kMinusKey = 0x2d, kOKey = 0x6f, kHKey = 0x68, kKKey = 0x6b, kTKey = 0x74, kMKey = 0x6d,
                               kBackspaceKey = 0xff08, k5Key = 0x35, k6Key = 0x36, k7Key = 0x37, k8Key = 0x38;

}  // namespace pellucida::test
