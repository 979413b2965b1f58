#include "StopListener.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <xcb/xcb.h>
#include <xcb/xinput.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace pellucida {
namespace {

constexpr xcb_keysym_t kEscape = 0xff1b;
constexpr int kMostLevels = 32;   // of windows within windows
constexpr int kMouseButtons = 3;  // the numbers above are the wheel's

// What the server sends and replies is freed by its reader.
struct Free {
  void operator()(void* memory) const noexcept { std::free(memory); }
};
template <class T>
using Reply = std::unique_ptr<T, Free>;

}  // namespace

// The connection, and the thread that reads it. Errors of requests come back in their replies and end nothing.
class StopListener::Connection {
 public:
  explicit Connection(std::function<void()> stop)
      : stop_(std::move(stop)), server_(xcb_connect(nullptr, nullptr)), wake_(eventfd(0, EFD_CLOEXEC)) {}

  ~Connection() {
    if (thread_.joinable()) {
      const std::uint64_t one = 1;
      end_ = true;
      if (write(wake_, &one, sizeof one) != sizeof one) std::abort();
      thread_.join();
    }
    if (wake_ >= 0) close(wake_);
    xcb_disconnect(server_);
  }

  // Why it can't listen; empty when it does.
  std::string start() {
    if (xcb_connection_has_error(server_) != 0) return "no X server answers";
    if (wake_ < 0) return "the system gives no event counter";
    root_ = xcb_setup_roots_iterator(xcb_get_setup(server_)).data->root;
    const auto* extension = xcb_get_extension_data(server_, &xcb_input_id);
    if (!extension || extension->present == 0) return "the X server has no XInput";
    opcode_ = extension->major_opcode;
    const Reply<xcb_input_xi_query_version_reply_t> version(
        xcb_input_xi_query_version_reply(server_, xcb_input_xi_query_version(server_, 2, 2), nullptr));
    if (!version || version->major_version < 2) return "the X server has no XInput 2";
    // Raw events go to everybody who asks, whoever holds keyboard or pointer.
    struct {
      xcb_input_event_mask_t head;
      std::uint32_t kinds;
    } wanted{{XCB_INPUT_DEVICE_ALL_MASTER, 1},
             XCB_INPUT_XI_EVENT_MASK_RAW_KEY_PRESS | XCB_INPUT_XI_EVENT_MASK_RAW_BUTTON_PRESS};
    const Reply<xcb_generic_error_t> refused(
        xcb_request_check(server_, xcb_input_xi_select_events_checked(server_, root_, 1, &wanted.head)));
    if (refused) return "the X server gives no raw events";
    find_escape();
    thread_ = std::thread([this] { listen(); });
    return {};
  }

  void set_active(bool active) noexcept { active_.store(active, std::memory_order_relaxed); }
  void set_button(const ButtonPlace& place) noexcept {
    const std::lock_guard lock(mutex_);
    button_ = place;
  }

 private:
  void listen() {
    std::array<pollfd, 2> wanted{{{xcb_get_file_descriptor(server_), POLLIN, 0}, {wake_, POLLIN, 0}}};
    while (!end_) {
      // A reply that was waited for may have brought events along.
      while (const Reply<xcb_generic_event_t> event{xcb_poll_for_event(server_)}) take(*event);
      if (xcb_connection_has_error(server_) != 0) return;
      poll(wanted.data(), wanted.size(), -1);
    }
  }

  void take(const xcb_generic_event_t& event) {
    const int kind = event.response_type & 0x7f;
    if (kind == XCB_MAPPING_NOTIFY) find_escape();
    if (kind != XCB_GE_GENERIC) return;
    const auto& generic = reinterpret_cast<const xcb_ge_generic_event_t&>(event);
    if (generic.extension != opcode_) return;
    const std::uint32_t detail = reinterpret_cast<const xcb_input_raw_key_press_event_t&>(event).detail;
    if (generic.event_type == XCB_INPUT_RAW_KEY_PRESS && detail == escape_ && active_ && !shift_held()) stop_();
    if (generic.event_type == XCB_INPUT_RAW_BUTTON_PRESS && detail <= kMouseButtons && pointer_on_button()) stop_();
  }

  // The key that bears Esc, which another keyboard layout may put elsewhere.
  void find_escape() {
    const auto* setup = xcb_get_setup(server_);
    const auto count = static_cast<std::uint8_t>(setup->max_keycode - setup->min_keycode + 1);
    const Reply<xcb_get_keyboard_mapping_reply_t> keys(
        xcb_get_keyboard_mapping_reply(server_, xcb_get_keyboard_mapping(server_, setup->min_keycode, count), nullptr));
    if (!keys) return;
    const xcb_keysym_t* symbols = xcb_get_keyboard_mapping_keysyms(keys.get());
    for (unsigned k = 0; k < count; ++k) {
      if (symbols[k * keys->keysyms_per_keycode] == kEscape) escape_ = setup->min_keycode + k;
    }
  }

  Reply<xcb_query_pointer_reply_t> pointer_in(xcb_window_t window) {
    return Reply<xcb_query_pointer_reply_t>(
        xcb_query_pointer_reply(server_, xcb_query_pointer(server_, window), nullptr));
  }

  bool shift_held() {
    const auto pointer = pointer_in(root_);
    return pointer && (pointer->mask & XCB_MOD_MASK_SHIFT) != 0;
  }

  // Down from the root, window in window, to the one that has the button: so nothing covers it there.
  bool pointer_on_button() {
    ButtonPlace place;
    {
      const std::lock_guard lock(mutex_);
      place = button_;
    }
    if (place.window == 0) return false;
    auto pointer = pointer_in(root_);
    for (int level = 0; pointer && pointer->child != XCB_NONE && level < kMostLevels; ++level) {
      const xcb_window_t below = pointer->child;
      pointer = pointer_in(below);
      if (below != place.window) continue;
      return pointer && pointer->win_x >= place.left_px && pointer->win_x < place.left_px + place.width_px &&
             pointer->win_y >= place.top_px && pointer->win_y < place.top_px + place.height_px;
    }
    return false;
  }

  std::function<void()> stop_;
  xcb_connection_t* server_;
  int wake_;
  xcb_window_t root_ = 0;
  std::uint8_t opcode_ = 0;
  std::uint32_t escape_ = 0;
  std::atomic<bool> active_{false}, end_{false};
  std::mutex mutex_;  // of the button's place
  ButtonPlace button_;
  std::thread thread_;
};

StopListener::StopListener(std::function<void()> stop) : connection_(std::make_unique<Connection>(std::move(stop))) {
  trouble_ = connection_->start();
}

StopListener::~StopListener() = default;

const std::string& StopListener::trouble() const noexcept {
  return trouble_;
}

void StopListener::set_active(bool active) noexcept {
  connection_->set_active(active);
}

void StopListener::set_button(const ButtonPlace& place) noexcept {
  connection_->set_button(place);
}

}  // namespace pellucida
