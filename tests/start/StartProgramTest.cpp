// The program on an X server: the start page, what is chosen there, and the page again.
#include <gtest/gtest.h>

#include <QApplication>
#include <QProcess>
#include <string>

#include "pellucida/core/TemporaryFolder.h"
#include "review/TouchSession.h"
#include "ui/DisplayTest.h"
#include "ui/ScreenWatch.h"
#include "ui/XInput.h"

namespace pellucida {
namespace {

constexpr std::uint32_t kReturnKey = 0xff0d, kControlKey = 0xffe3, kQKey = 0x71, kOneKey = 0x31, kFourKey = 0x34,
                        kAltKey = 0xffe9, kTabKey = 0xff09, kDownKey = 0xff54;

class StartProgramTest : public test::DisplayTest {
 protected:
  void begin(const QStringList& arguments = {"workstation", "--mode", "start"}) {
    auto environment = QProcessEnvironment::systemEnvironment();
    const QString home = QString::fromStdString(home_.path().string());
    environment.insert("HOME", home);
    environment.insert("XDG_CONFIG_HOME", home);
    program_.setProcessEnvironment(environment);
    program_.setProcessChannelMode(QProcess::ForwardedChannels);
    program_.start(PELLUCIDA_PROGRAM, arguments);
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
  test::ScreenWatch screen_;
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

TEST_F(StartProgramTest, ThePageLeadsFromOneSourceToAnother) {
  const std::string page = "Pellucida - Start";
  const auto to_page = [&] {
    input_.key(kAltKey, true);
    input_.tap(test::kHomeKey);
    input_.key(kAltKey, false);
  };
  // The window opened without the page has a way to it, too.
  begin({"workstation", "--source", "virtual:default", "--hand", "none"});
  ASSERT_TRUE(shows("Pellucida - virtual:default"));
  ASSERT_TRUE(press_until_gone("Pellucida - virtual:default", to_page));
  ASSERT_TRUE(shows(page));
  // The first card; in the list of scenarios, the next one.
  for (const char* scenario : {"Pellucida - virtual:injection", "Pellucida - virtual:configuration-2"}) {
    ASSERT_TRUE(press_until_gone(page, [&] {
      if (std::string(scenario) == "Pellucida - virtual:configuration-2") {
        input_.tap(kOneKey);
        pass(200);
        input_.tap(kTabKey);
        pass(200);
        input_.tap(kDownKey);
        pass(200);
      } else {
        input_.tap(kOneKey);
      }
      input_.tap(kReturnKey);
    }));
    ASSERT_TRUE(shows(scenario)) << scenario;
    ASSERT_TRUE(press_until_gone(scenario, to_page));
    ASSERT_TRUE(shows(page));
  }
  ASSERT_TRUE(press_until_gone(page, [&] { quit(); }));
  ASSERT_TRUE(pass_until([&] { return program_.state() == QProcess::NotRunning; }));
  EXPECT_EQ(program_.exitCode(), 0);
}

TEST_F(StartProgramTest, APathOfASessionOpensReview) {
  test::write_touch(home_ / "S");
  begin({QString::fromStdString((home_ / "S" / "session.json").string())});
  ASSERT_TRUE(
      pass_until([&] { return program_.state() == QProcess::NotRunning || screen_.find("Pellucida - Review of S"); }));
  program_.terminate();
  ASSERT_TRUE(pass_until([&] { return program_.state() == QProcess::NotRunning; }));
}

}  // namespace
}  // namespace pellucida
