#pragma once
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ReviewWindow.h"
#include "pellucida/core/TemporaryFolder.h"
#include "review/TouchSession.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "widgets/TimelineBar.h"

namespace pellucida::test {

/// The window in Review mode with that session at hand, a clock that the test sets, and a person's answers by the test.
class ReviewWindowTest : public DisplayTest {
 protected:
  static void SetUpTestSuite() {
    DisplayTest::SetUpTestSuite();
    folder_ = std::make_unique<TemporaryFolder>();
    write_touch(*folder_ / "S");
  }
  static void TearDownTestSuite() { folder_.reset(); }

  ReviewWindowTest() {
    FileChoice choice;
    choice.file_to_write = [this](const QString&, const std::filesystem::path& proposal, const QString&) {
      proposals_.push_back(proposal);
      return answer_;
    };
    choice.folder_to_write = [this](const QString&, const std::filesystem::path&) { return answer_; };
    choice.session = [this](const QString&) { return answer_; };
    choice.may_replace = [this](const std::vector<std::filesystem::path>&) {
      ++questions_;
      return replace_;
    };
    choice.show_page = [this](const std::filesystem::path& page) { pages_.push_back(page); };
    window_ = std::make_unique<ReviewWindow>(ReviewOptions{}, clock_, choice);
    window_->show();
  }

  bool shows(std::size_t step) {
    return pass_until([&] { return window_->shown_step() == step; });
  }
  void open() {
    window_->open(*folder_ / "S");
    ASSERT_TRUE(pass_until([&] { return window_->shown_step() == 0U; })) << text("problem");
    ASSERT_TRUE(activate(*window_)) << "not active";
    pass(100);
  }
  std::string text(const char* label) const {
    const auto* found = window_->findChild<QLabel*>(label);
    return found ? found->text().toStdString() : std::string("no label ") + label;
  }
  void trigger(const char* action) { window_->findChild<QAction*>(action)->trigger(); }

  // A press of the left button at a place of a widget, and its release `by` pixels on.
  void click(QWidget& widget, QPoint place, QPoint by = {}) {
    const QPoint from = widget.mapToGlobal(place), to = widget.mapToGlobal(place + by);
    input_.move(from.x(), from.y());
    pass(50);
    input_.left_button(true);
    pass(50);
    input_.move(to.x(), to.y());
    pass(50);
    input_.left_button(false);
    pass(50);
  }
  TimelineBar& timeline() { return *dynamic_cast<TimelineBar*>(window_->findChild<QWidget*>("timeline")); }
  double recorded_uN(std::size_t step) const { return window_->session()->rows[step].contact_force_uN; }

  inline static std::unique_ptr<TemporaryFolder> folder_;
  XInput input_;
  std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  std::filesystem::path answer_;
  std::vector<std::filesystem::path> proposals_, pages_;
  int questions_ = 0;
  bool replace_ = false;
  std::unique_ptr<ReviewWindow> window_;
};

}  // namespace pellucida::test
