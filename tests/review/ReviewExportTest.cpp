// What Review mode writes, and the thread it works on.
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "BackgroundTask.h"
#include "review/ReviewWindowFixture.h"
#include "support/Files.h"
#include "support/WaitUntil.h"

namespace pellucida {
namespace {

using namespace test;

TEST_F(ReviewWindowTest, ExportsWriteFilesAndAskBeforeReplacing) {
  open();
  const TemporaryFolder out;
  answer_ = out / "window.png";
  trigger("exportWindow");
  EXPECT_TRUE(std::filesystem::exists(answer_));
  EXPECT_EQ(proposals_.back().filename(), "S-window.png");
  answer_ = out / "3d.png";
  trigger("exportView");
  EXPECT_TRUE(std::filesystem::exists(answer_));
  answer_ = out / "force.svg";
  trigger("exportTime");
  EXPECT_NE(test::text_of(answer_).find("<svg"), std::string::npos);
  answer_ = out / "force.pdf";
  trigger("exportTouch");
  EXPECT_EQ(test::text_of(answer_).rfind("%PDF", 0), 0U);
  // The window shows on after drawing elsewhere.
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(1));

  answer_ = out / "tables";
  trigger("exportTables");
  ASSERT_TRUE(pass_until([&] { return text("notice").find("tables written") != std::string::npos; })) << text("notice");
  EXPECT_NE(test::text_of(answer_ / "measurements.csv").find("contact_force_uN"), std::string::npos);
  EXPECT_EQ(questions_, 0);
  test::put(answer_ / "measurements.csv", "mine");
  trigger("exportTables");
  pass(200);
  EXPECT_EQ(questions_, 1);
  EXPECT_EQ(test::text_of(answer_ / "measurements.csv"), "mine");
  answer_.clear();
  trigger("exportWindow");
  EXPECT_EQ(questions_, 1);
}

TEST_F(ReviewWindowTest, TheReportIsWrittenInTheBackgroundAndShown) {
  open();
  const TemporaryFolder out;
  answer_ = out / "passport.html";
  trigger("report");
  ASSERT_TRUE(pass_until([&] { return !pages_.empty(); })) << text("notice");
  EXPECT_EQ(pages_.front(), answer_);
  EXPECT_NE(test::text_of(answer_).find("<html"), std::string::npos);
}

class BackgroundTaskTest : public DisplayTest {
 protected:
  static bool pass_until(const std::function<bool()>& condition) {
    return wait_until([&] {
      QApplication::processEvents();
      return condition();
    });
  }
};

TEST_F(BackgroundTaskTest, BringsProgressAndResultToTheWindowsThread) {
  BackgroundTask task;
  std::size_t progress = 0;
  int result = 0;
  const auto here = std::this_thread::get_id();
  task.run(
      [&](const BackgroundTask::Control& control) -> std::function<void()> {
        EXPECT_NE(std::this_thread::get_id(), here);
        control.progress(3, 4);
        return [&] {
          EXPECT_EQ(std::this_thread::get_id(), here);
          result = 7;
        };
      },
      [&](std::size_t done, std::size_t) { progress = done; },
      [](const std::string& error) { ADD_FAILURE() << error; });
  EXPECT_TRUE(task.running());
  ASSERT_TRUE(pass_until([&] { return result == 7; }));
  EXPECT_EQ(progress, 3U);
  EXPECT_FALSE(task.running());
}

TEST_F(BackgroundTaskTest, AFailureIsItsText) {
  BackgroundTask task;
  std::string problem;
  task.run([](const BackgroundTask::Control&) -> std::function<void()> { throw std::runtime_error("no room"); }, {},
           [&](const std::string& error) { problem = error; });
  ASSERT_TRUE(pass_until([&] { return !problem.empty(); }));
  EXPECT_EQ(problem, "no room");
}

TEST_F(BackgroundTaskTest, NothingArrivesOfWorkThatWasCancelled) {
  BackgroundTask task;
  std::atomic<bool> begun = false;
  bool heard = false;
  const auto hear = [&](auto&&...) { heard = true; };
  task.run(
      [&](const BackgroundTask::Control& control) -> std::function<void()> {
        begun = true;
        for (;;) control.progress(1, 2);
      },
      hear, hear);
  ASSERT_TRUE(wait_until([&] { return begun.load(); }));
  task.cancel();
  QApplication::processEvents();
  EXPECT_FALSE(heard);
  EXPECT_FALSE(task.running());
}

TEST_F(BackgroundTaskTest, WorkAskedToEndBringsWhatItHas) {
  BackgroundTask task;
  std::size_t count = 0;
  std::atomic<bool> begun = false;
  task.run(
      [&](const BackgroundTask::Control& control) -> std::function<void()> {
        std::size_t done = 0;
        while (control.go_on(++done, 0)) begun = true;
        return [&count, done] { count = done; };
      },
      {}, {});
  ASSERT_TRUE(wait_until([&] { return begun.load(); }));
  task.ask_to_end();
  EXPECT_TRUE(pass_until([&] { return count > 0; }));
}

}  // namespace
}  // namespace pellucida
