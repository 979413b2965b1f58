// Review mode annotated: notes at a time, at a place in the image, changed, deleted, undone; kept in the session.
#include <gtest/gtest.h>

#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <fstream>

#include "ReviewViews.h"
#include "pellucida/session/Annotations.h"
#include "review/ReviewWindowFixture.h"
#include "widgets/FeedPanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using namespace test;

constexpr std::uint32_t kAKey = 0x61, kUKey = 0x75, kSKey = 0x73, kZKey = 0x7a, kControlKey = 0xffe3,
                        kReturnKey = 0xff0d;

class NotesWindow : public ReviewWindowTest {
 protected:
  void SetUp() override {
    session_ = *own_ / "N";
    write_touch(session_);
  }
  void open_at(std::size_t step) {
    window_->open(session_);
    ASSERT_TRUE(shows(0)) << text("problem");
    ASSERT_TRUE(activate(*window_)) << "not active";
    go_right(step);
    ASSERT_TRUE(shows(step));
  }
  void go_right(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      input_.tap(kRightKey);
      pass(60);
    }
  }
  void type(std::initializer_list<std::uint32_t> keys) {
    for (const std::uint32_t key : keys) {
      input_.tap(key);
      pass(30);
    }
  }
  void undo() {
    input_.key(kControlKey, true);
    input_.tap(kZKey);
    input_.key(kControlKey, false);
    pass(60);
  }
  bool strip_is_shown() const { return window_->findChild<QLineEdit*>("noteText")->isVisible(); }
  std::vector<Annotation> kept() const { return read_annotations(session_); }
  long marks_on_timeline() {
    const auto& events = timeline().timeline().events;
    return std::count_if(events.begin(), events.end(), [](const auto& one) { return one.kind == kAnnotationKind; });
  }

  std::unique_ptr<TemporaryFolder> own_ = std::make_unique<TemporaryFolder>();
  std::filesystem::path session_;
};

TEST_F(NotesWindow, ANoteIsWrittenChangedDeletedAndBroughtBack) {
  open_at(3);
  EXPECT_FALSE(strip_is_shown());
  input_.tap(kAKey);
  ASSERT_TRUE(pass_until([&] { return strip_is_shown(); }));
  // Letters are the note's while it is written, not the window's keys.
  type({kSKey, kAKey, kUKey, kReturnKey});
  ASSERT_TRUE(pass_until([&] { return kept().size() == 1; }));
  EXPECT_EQ(kept()[0].text, "sau");
  EXPECT_NEAR(kept()[0].time_s, 0.3, 1e-9);
  EXPECT_FALSE(kept()[0].node);
  EXPECT_EQ(marks_on_timeline(), 1);
  EXPECT_EQ(window_->shown_step(), 3U);

  // The note is there when its frame is, and not elsewhere.
  pass(100);
  go_right(1);
  ASSERT_TRUE(shows(4));
  EXPECT_FALSE(strip_is_shown());
  input_.tap(kLeftKey);
  ASSERT_TRUE(shows(3));
  EXPECT_TRUE(strip_is_shown());
  EXPECT_EQ(window_->findChild<QLineEdit*>("noteText")->text(), "sau");

  auto* line = window_->findChild<QLineEdit*>("noteText");
  line->setText("Ooplasm follows");
  emit line->returnPressed();
  EXPECT_EQ(kept()[0].text, "Ooplasm follows");
  window_->findChild<QPushButton*>("noteDelete")->click();
  EXPECT_TRUE(kept().empty());
  EXPECT_EQ(marks_on_timeline(), 0);
  EXPECT_FALSE(strip_is_shown());
  window_->setFocus();
  undo();
  ASSERT_TRUE(pass_until([&] { return kept().size() == 1; }));
  EXPECT_EQ(kept()[0].text, "Ooplasm follows");
  undo();
  ASSERT_TRUE(pass_until([&] { return kept().size() == 1 && kept()[0].text == "sau"; }));
  EXPECT_EQ(marks_on_timeline(), 1);
}

TEST_F(NotesWindow, ANoteAtAPlaceIsMarkedThere) {
  open_at(2);
  input_.key(kShiftKey, true);
  input_.tap(kAKey);
  input_.key(kShiftKey, false);
  pass(300);
  auto& views = const_cast<ReviewViews&>(window_->views());
  ViewWidget& view = views.feed().view();
  const QPoint place(view.width() / 3, view.height() / 3);
  const Eigen::Vector2d place_um = views.image().place_um(place.x(), place.y(), view.height());
  click(view, place);
  ASSERT_TRUE(pass_until([&] { return strip_is_shown(); }));
  auto* line = window_->findChild<QLineEdit*>("noteText");
  line->setText("Dust");
  emit line->returnPressed();
  ASSERT_EQ(kept().size(), 1u);
  ASSERT_TRUE(kept()[0].place_um);
  EXPECT_NEAR(kept()[0].place_um->x_um, place_um.x(), 1.0);
  EXPECT_NEAR(kept()[0].place_um->y_um, place_um.y(), 1.0);
  EXPECT_EQ(window_->findChild<QLabel*>("noteWhere")->text().left(7), "Note at");
  // There again when the session is opened again.
  window_->open(session_);
  ASSERT_TRUE(shows(0));
  EXPECT_EQ(marks_on_timeline(), 1);
}

TEST_F(NotesWindow, NotesThatCannotBeReadAreLeftAlone) {
  std::ofstream(session_ / kAnnotationsFile) << "gibberish\n";
  window_->open(session_);
  ASSERT_TRUE(shows(0));
  EXPECT_NE(text("notice").find("annotations.csv: line 1"), std::string::npos) << text("notice");
  window_->findChild<QAction*>("noteHere")->trigger();
  EXPECT_FALSE(strip_is_shown());
  EXPECT_NE(text("notice").find("can't be read"), std::string::npos) << text("notice");
  std::ifstream file(session_ / kAnnotationsFile);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "gibberish");
}

}  // namespace
}  // namespace pellucida
