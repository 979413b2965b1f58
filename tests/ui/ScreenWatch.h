#pragma once
#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

namespace pellucida::test {

/// Looks at the windows of all programs.
class ScreenWatch {
 public:
  ScreenWatch() : server_(xcb_connect(nullptr, nullptr)) {}
  ~ScreenWatch() { xcb_disconnect(server_); }
  ScreenWatch(const ScreenWatch&) = delete;
  ScreenWatch& operator=(const ScreenWatch&) = delete;

  /// The shown top window with this title.
  std::optional<xcb_window_t> find(const std::string& title) const {
    const xcb_window_t root = xcb_setup_roots_iterator(xcb_get_setup(server_)).data->root;
    auto* tree = xcb_query_tree_reply(server_, xcb_query_tree(server_, root), nullptr);
    std::optional<xcb_window_t> found;
    for (int k = 0; tree && k < xcb_query_tree_children_length(tree); ++k) {
      const xcb_window_t window = xcb_query_tree_children(tree)[k];
      if (is_shown(window) && title_of(window) == title) found = window;
    }
    std::free(tree);
    return found;
  }
  /// There is no window manager: somebody must say where the keys go.
  void focus(xcb_window_t window) const {
    xcb_set_input_focus(server_, XCB_INPUT_FOCUS_PARENT, window, XCB_CURRENT_TIME);
    xcb_flush(server_);
  }

 private:
  bool is_shown(xcb_window_t window) const {
    auto* state = xcb_get_window_attributes_reply(server_, xcb_get_window_attributes(server_, window), nullptr);
    const bool shown = state && state->map_state == XCB_MAP_STATE_VIEWABLE;
    std::free(state);
    return shown;
  }
  std::string title_of(xcb_window_t window) const {
    constexpr std::uint32_t kMostLetters = 64;
    const auto asked =
        xcb_get_property(server_, 0, window, XCB_ATOM_WM_NAME, XCB_GET_PROPERTY_TYPE_ANY, 0, kMostLetters);
    auto* name = xcb_get_property_reply(server_, asked, nullptr);
    std::string title;
    if (name) {
      title.assign(static_cast<const char*>(xcb_get_property_value(name)),
                   static_cast<std::size_t>(xcb_get_property_value_length(name)));
    }
    std::free(name);
    return title;
  }

  xcb_connection_t* server_;
};

}  // namespace pellucida::test
