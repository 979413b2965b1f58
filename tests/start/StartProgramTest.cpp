// The program on an X server: the start page, what is chosen there, and the page again.
#include <gtest/gtest.h>
#include <xcb/xcb.h>

#include <QApplication>
#include <QProcess>
#include <cstdlib>
#include <optional>
#include <string>

#include "pellucida/core/TemporaryFolder.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"

namespace pellucida {
namespace {

constexpr std::uint32_t kReturnKey = 0xff0d, kControlKey = 0xffe3, kQKey = 0x71, kOneKey = 0x31, kFourKey = 0x34;

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

class StartProgramTest : public test::DisplayTest {
 protected:
  void begin() {
    auto environment = QProcessEnvironment::systemEnvironment();
    const QString home = QString::fromStdString(home_.path().string());
    environment.insert("HOME", home);
    environment.insert("XDG_CONFIG_HOME", home);
    program_.setProcessEnvironment(environment);
    program_.setProcessChannelMode(QProcess::ForwardedChannels);
    program_.start(PELLUCIDA_PROGRAM, {"workstation", "--mode", "start"});
  }
  ~StartProgramTest() override {
    program_.kill();
    program_.waitForFinished();
  }

  // Waits for a window and gives it the keyboard.
  bool shows(const std::string& title) {
    const bool shown = pass_until([&] { return program_.state() == QProcess::NotRunning || screen_.find(title); });
    const auto window = screen_.find(title);
    if (!shown || !window) return false;
    screen_.focus(*window);
    pass(500);
    return true;
  }
  // As a person does who sees that nothing happened: the press may come before the window listens.
  bool press_until_gone(const std::string& title, const std::function<void()>& press) {
    return pass_until([&] {
      const auto window = screen_.find(title);
      if (!window) return true;
      screen_.focus(*window);
      press();
      pass(1000);
      return !screen_.find(title);
    });
  }
  void quit() {
    input_.key(kControlKey, true);
    input_.tap(kQKey);
    input_.key(kControlKey, false);
  }

  TemporaryFolder home_;
  test::XInput input_;
  ScreenWatch screen_;
  QProcess program_;
};

TEST_F(StartProgramTest, AWindowChosenOnThePageLeadsBackToItWhenItIsClosed) {
  const std::string page = "Pellucida - Start";
  begin();
  ASSERT_TRUE(shows(page));
  for (const auto& mode :
       {std::pair(kFourKey, "Pellucida, teach"), std::pair(kOneKey, "Pellucida - virtual:injection")}) {
    const std::string title = mode.second;
    ASSERT_TRUE(press_until_gone(page, [&] {
      input_.tap(mode.first);
      input_.tap(kReturnKey);
    }));
    ASSERT_TRUE(shows(title)) << title;
    ASSERT_TRUE(press_until_gone(title, [&] { quit(); })) << title;
    ASSERT_TRUE(shows(page)) << "after " << title;
  }
  ASSERT_TRUE(press_until_gone(page, [&] { quit(); }));
  ASSERT_TRUE(pass_until([&] { return program_.state() == QProcess::NotRunning; }));
  EXPECT_EQ(program_.exitStatus(), QProcess::NormalExit);
  EXPECT_EQ(program_.exitCode(), 0);
}

}  // namespace
}  // namespace pellucida
