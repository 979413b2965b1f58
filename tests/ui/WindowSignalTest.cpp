// The program's windows on an X server, ended by a signal: what they record is closed whole.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QByteArray>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "DisplayTest.h"
#include "ScreenWatch.h"
#include "XInput.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/session/SessionCheck.h"
#include "support/Files.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kRKey = 0x72, kSKey = 0x73;
constexpr int kOutputUnwritable = 5;
constexpr const char* kGuideTitle = "Pellucida - virtual:default";

class WindowSignals : public test::DisplayTest {
 protected:
  ~WindowSignals() override {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  /// `most_bytes`: no file may grow larger; 0: no limit.
  void begin(std::vector<std::string> arguments, rlim_t most_bytes = 0) {
    arguments.insert(arguments.begin(), "pellucida");
    const std::string home = folder_.path().string(), err = (folder_ / "err.txt").string();
    child_ = fork();
    ASSERT_GE(child_, 0);
    if (child_ > 0) return;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) signal(number, SIG_DFL);
    setenv("HOME", home.c_str(), 1);
    setenv("XDG_CONFIG_HOME", home.c_str(), 1);
    if (!std::freopen("/dev/null", "w", stdout) || !std::freopen(err.c_str(), "w", stderr)) _exit(99);
    const rlimit limit{most_bytes, most_bytes};
    if (most_bytes > 0 && setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(99);
    std::vector<char*> words;
    for (std::string& one : arguments) words.push_back(one.data());
    words.push_back(nullptr);
    execv(PELLUCIDA_PROGRAM, words.data());
    _exit(99);
  }

  bool is_running() {
    if (child_ > 0 && waitpid(child_, &status_, WNOHANG) == child_) child_ = 0;
    return child_ > 0;
  }

  // The window is there, and hears keys.
  bool shows(const std::string& title) {
    if (!pass_until([&] { return !is_running() || screen_.find(title).has_value(); })) return false;
    const auto window = screen_.find(title);
    if (!window) return false;
    screen_.focus(*window);
    return true;
  }

  // As a person who presses until something happens: the window may not listen yet.
  bool press_until(const std::string& title, std::uint32_t key, const std::function<bool()>& happened) {
    return pass_until([&] {
             if (happened()) return true;
             const auto window = screen_.find(title);
             if (!window) return !is_running();
             screen_.focus(*window);
             pass(200);
             input_.tap(key);
             pass(3000);
             return happened();
           }) &&
           happened();
  }

  fs::path session() const { return folder_ / "session"; }
  long row_count() const {
    const std::string text = fs::exists(session()) ? test::text_of(session() / "measurements.csv") : std::string();
    return std::count(text.begin(), text.end(), '\n') - 1;
  }
  bool record() {
    return shows(kGuideTitle) && press_until(kGuideTitle, kRKey, [&] { return fs::exists(session()); }) &&
           pass_until([&] { return row_count() > 5; });
  }

  // Sends it, and waits for the end.
  void end_by(int number) {
    kill(child_, number);
    ASSERT_TRUE(pass_until([&] { return !is_running(); })) << "it goes on after signal " << number;
  }
  void expect_ended_by(int number) const {
    EXPECT_TRUE(WIFSIGNALED(status_)) << "exit code " << WEXITSTATUS(status_);
    EXPECT_EQ(WTERMSIG(status_), number);
    EXPECT_NE(test::text_of(folder_ / "err.txt").find("completing what is done"), std::string::npos);
  }
  void expect_whole_session() const {
    EXPECT_EQ(nlohmann::json::parse(test::text_of(session() / "session.json"))["complete"], true);
    EXPECT_NE(test::text_of(session() / "events.csv").find(",stopped,"), std::string::npos);
    const SessionReport report = check_session(session(), false);
    EXPECT_TRUE(report.fine()) << report.problems.front();
  }

  TemporaryFolder folder_;
  test::XInput input_;
  test::ScreenWatch screen_;
  pid_t child_ = 0;
  int status_ = 0;
};

TEST_F(WindowSignals, ARecordingIsClosedWholeAndTheShellSeesTheSignal) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    fs::remove_all(session());
    begin({"workstation", "--source", "virtual:default", "--hand", "none", "--session", session().string()});
    ASSERT_TRUE(record()) << test::text_of(folder_ / "err.txt");
    end_by(number);
    expect_ended_by(number);
    expect_whole_session();
  }
}

// With a hand, whose ticks are recorded too.
TEST_F(WindowSignals, TheHandsLastTicksAreInTheRecording) {
  begin({"workstation", "--source", "virtual:default", "--hand", "demonstration", "--session", session().string()});
  ASSERT_TRUE(record()) << test::text_of(folder_ / "err.txt");
  end_by(SIGTERM);
  expect_ended_by(SIGTERM);
  expect_whole_session();
  EXPECT_TRUE(fs::exists(session() / "haptics/haptics_00000000.vtp"));
}

// A dialog has an event loop of its own.
TEST_F(WindowSignals, AnOpenDialogHoldsNothingUp) {
  begin({"workstation", "--source", "virtual:default", "--hand", "none", "--session", session().string()});
  ASSERT_TRUE(record()) << test::text_of(folder_ / "err.txt");
  ASSERT_TRUE(press_until(kGuideTitle, kSKey, [&] { return screen_.find("Scale of this cell").has_value(); }));
  end_by(SIGTERM);
  expect_ended_by(SIGTERM);
  expect_whole_session();
}

TEST_F(WindowSignals, WindowsWithoutARecordingEndToo) {
  const std::vector<std::pair<std::string, std::string>> modes{{"teach", "Pellucida, teach"},
                                                               {"start", "Pellucida - Start"}};
  for (const auto& mode : modes) {
    begin({"workstation", "--mode", mode.first});
    ASSERT_TRUE(shows(mode.second)) << test::text_of(folder_ / "err.txt");
    end_by(SIGTERM);
    expect_ended_by(SIGTERM);
  }
}

// What could not be written is said at the end too, and counts for more than the signal.
TEST_F(WindowSignals, ARecordingThatCouldNotBeClosedIsAnErrorOfTheOutput) {
  constexpr rlim_t kLessThanAnImage = 60000;
  begin({"workstation", "--source", "virtual:default", "--hand", "none", "--session", session().string()},
        kLessThanAnImage);
  ASSERT_TRUE(shows(kGuideTitle)) << test::text_of(folder_ / "err.txt");
  ASSERT_TRUE(press_until(kGuideTitle, kRKey, [&] { return fs::exists(session() / "measurements.csv"); }));
  pass(2000);
  end_by(SIGTERM);
  ASSERT_TRUE(WIFEXITED(status_));
  EXPECT_EQ(WEXITSTATUS(status_), kOutputUnwritable);
  EXPECT_NE(test::text_of(folder_ / "err.txt").find("can't be written"), std::string::npos);
}

}  // namespace
}  // namespace pellucida
