// The real window on an X server: what a person does in it beside the stop.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "GuideFixture.h"
#include "pellucida/core/CellNameNote.h"
#include "pellucida/core/NewCellNote.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionCheck.h"
#include "pellucida/session/SessionReader.h"
#include "support/Files.h"
#include "widgets/GaugeBar.h"
#include "widgets/KeySheet.h"

namespace pellucida {
namespace {

constexpr std::uint32_t kF1Key = 0xffbe, kEnterKey = 0xff0d, kControlKey = 0xffe3, kDKey = 0x64, kEKey = 0x65,
                        kNKey = 0x6e, kRKey = 0x72, kUKey = 0x75, kZKey = 0x7a;

class GuideControlsTest : public GuideWindowTest {
 protected:
  void tap_with(std::initializer_list<std::uint32_t> held, std::uint32_t key) {
    for (const std::uint32_t one : held) input_.key(one, true);
    input_.tap(key);
    for (const std::uint32_t one : held) input_.key(one, false);
  }
  template <class Widget>
  Widget* named(const char* name) {
    return window_->findChild<Widget*>(name);
  }
  bool is_shown(const char* name) {
    auto* widget = named<QWidget>(name);
    return widget && widget->isVisible();
  }
  bool has_event(const std::string& detail) const {
    const auto events = run_->events_since(0);
    return std::any_of(events.begin(), events.end(), [&](const Event& event) { return event.detail == detail; });
  }
  void wait_for_plan() {
    ASSERT_TRUE(pass_until([&] { return console_->plan().has_value() && console_->may_replan(); }));
    pass(300);
  }
  Eigen::Vector2d target_um() const { return console_->plan()->target_um.eigen().head<2>(); }
  void move_to(const Eigen::Vector2d& place_um) {
    const QPoint at = on_screen(*window_, place_um);
    input_.move(at.x(), at.y());
    pass(150);
  }
  void drag(const Eigen::Vector2d& from_um, const Eigen::Vector2d& to_um) {
    move_to(from_um);
    input_.left_button(true);
    pass(100);
    move_to(0.5 * (from_um + to_um));
    move_to(to_um);
    input_.left_button(false);
    pass(200);
  }
  FeedView& feed() {
    for (auto* one : ViewWidget::all_in(*window_)) {
      if (auto* view = dynamic_cast<FeedView*>(&one->view())) return *view;
    }
    throw std::logic_error("no feed");
  }
};

TEST_F(GuideControlsTest, TheSheetHasAllKeysAndEscapeStillStops) {
  open();
  std::set<QString> listed;
  for (const KeyEntry& entry : keys_of_window(*window_)) {
    listed.insert(entry.keys);
    EXPECT_FALSE(entry.meaning.isEmpty()) << entry.keys.toStdString();
    EXPECT_FALSE(entry.group.isEmpty()) << entry.keys.toStdString();
  }
  for (const char* key : {"F1", "Esc", "Shift+Esc", "D", "X", "G", "R", "O", "Backspace", "W", "V", "P", "Ctrl+1",
                          "Ctrl+Z", "Ctrl+Q", "Shift+N", "Ctrl+click"}) {
    EXPECT_TRUE(listed.contains(key)) << key;
  }
  input_.tap(kF1Key);
  ASSERT_TRUE(pass_until([&] { return is_shown("keySheet"); }));
  pass(300);
  keep_picture(*window_, "guide-keys-1400");
  // Nothing of it is cut off at the smallest size; the stop is beside it.
  window_->resize(1000, 640);
  pass(500);
  keep_picture(*window_, "guide-keys-1000");
  const QWidget* sheet = named<QWidget>("keySheet");
  EXPECT_TRUE(window_->rect().contains(sheet->geometry()));
  EXPECT_FALSE(sheet->geometry().contains(stop().mapTo(window_.get(), stop().rect().center())));
  input_.tap(kF1Key);
  ASSERT_TRUE(pass_until([&] { return !is_shown("keySheet"); }));
  input_.tap(kF1Key);
  ASSERT_TRUE(pass_until([&] { return is_shown("keySheet"); }));
  input_.tap(test::kEscapeKey);
  EXPECT_TRUE(pass_until([&] { return state() == HandState::kStopped; }));
  EXPECT_TRUE(pass_until([&] { return !is_shown("keySheet"); }));
}

TEST_F(GuideControlsTest, WhileTheWindowAsksTheRecordingGoesOnAndItEndsWhole) {
  open();
  input_.tap(kRKey);
  ASSERT_TRUE(pass_until([&] { return run_->status().recorded_count > 3; }));
  EXPECT_TRUE(pass_until([&] { return named<QPushButton>("record")->text() == "End recording"; }));
  const std::string folder = run_->status().recording_folder;
  window_->close();
  ASSERT_TRUE(window_->isVisible());
  const auto count = run_->status().recorded_count;
  EXPECT_TRUE(pass_until([&] { return run_->status().recorded_count > count + 3; }));
  named<QPushButton>("endAndClose")->click();
  EXPECT_FALSE(window_->isVisible());
  window_->end_run();
  const SessionReport report = check_session(folder, false);
  EXPECT_TRUE(report.fine()) << report.problems.front();
  EXPECT_GT(SessionReader(folder).measurements().size(), count + 3);
}

TEST_F(GuideControlsTest, TheCamerasExposureIsSetInTheImagesMenuAndNoted) {
  open();
  wait_for_plan();
  const auto mean_grey = [&] {
    const auto scene = run_->frames()->peek();
    const ImageView image = view_of(scene->frame.get());
    const auto* row = static_cast<const unsigned char*>(image.data);
    double sum = 0.0;
    for (int x = 0; x < image.width_px; ++x) sum += row[x];
    return sum / image.width_px;
  };
  const double before = mean_grey();
  auto* menu = named<QToolButton>("image")->menu();
  menu->popup(window_->mapToGlobal(QPoint(200, 200)));
  ASSERT_TRUE(pass_until([&] { return menu->isVisible(); }));
  pass(300);
  keep_picture(*window_, "guide-exposure");
  auto* slider = named<QSlider>("exposure");
  ASSERT_TRUE(slider);
  EXPECT_FALSE(named<QCheckBox>("exposureAutomatic")->isVisible()) << "the virtual camera has no automatic";
  slider->setValue(30);  // 2 ms (30 / 2)^0.3 = 4.5 ms of 10
  menu->close();
  EXPECT_TRUE(pass_until([&] { return std::abs(mean_grey() / before - 0.45) < 0.02; })) << mean_grey() / before;
  EXPECT_TRUE(pass_until([&] { return has_event("camera exposure: 4.5 ms"); }));
}

TEST_F(GuideControlsTest, AWindowThatRecordsNothingClosesAtOnce) {
  open();
  window_->close();
  EXPECT_FALSE(window_->isVisible());
}

TEST_F(GuideControlsTest, ADisplayModeShowsAndFeelsWhatThePaperSays) {
  open();
  wait_for_plan();
  const auto* space = window_->findChild<QAction*>("modality_guide");
  EXPECT_TRUE(space->isChecked());
  auto* panel = named<QWidget>("space");
  ASSERT_TRUE(panel);
  tap_with({kControlKey}, '1');
  ASSERT_TRUE(pass_until([&] { return !panel->isVisible(); }));
  EXPECT_FALSE(console_->haptics());
  EXPECT_FALSE(console_->guided());
  EXPECT_TRUE(has_event("display: 2-D image"));
  pass(300);
  keep_picture(*window_, "guide-2d");
  tap_with({kControlKey}, '3');
  ASSERT_TRUE(pass_until([&] { return panel->isVisible(); }));
  EXPECT_TRUE(console_->haptics());
  EXPECT_FALSE(console_->guided());
  EXPECT_TRUE(has_event("display: 3-D + haptics"));
  // The guide's own key makes it the fourth.
  input_.tap('g');
  ASSERT_TRUE(pass_until([&] { return space->isChecked(); }));
  EXPECT_TRUE(has_event("display: 3-D + haptics + guide"));
  // A recording says in which mode it began.
  input_.tap(kRKey);
  ASSERT_TRUE(pass_until([&] { return run_->status().recorded_count > 3; }));
  const std::string folder = run_->status().recording_folder;
  input_.tap(kRKey);
  ASSERT_TRUE(pass_until([&] { return !run_->status().recording; }));
  const auto events = SessionReader(folder).events();
  EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                          [](const Event& event) { return event.detail == "display: 3-D + haptics + guide"; }));
}

TEST_F(GuideControlsTest, ThePlanIsDraggedOnTheImageUndoneAndHidden) {
  open();
  wait_for_plan();
  const Eigen::Vector2d before_um = target_um(), up_um(0.0, -9.0);
  move_to(before_um);
  EXPECT_TRUE(pass_until([&] { return feed().plan()->handle == PlanHandle::kTarget; }));
  EXPECT_TRUE(feed().plan()->has_handles);
  pass(200);
  keep_picture(*window_, "guide-plan-handles");
  drag(before_um, before_um + up_um);
  const auto target_is_at = [&](const Eigen::Vector2d& place_um) {
    return pass_until([&] { return (target_um() - place_um).norm() < 1.5; });
  };
  ASSERT_TRUE(target_is_at(before_um + up_um));
  // The click moved no needle.
  EXPECT_EQ(state(), kReady);
  tap_with({kControlKey}, kZKey);
  EXPECT_TRUE(target_is_at(before_um));
  tap_with({kControlKey, test::kShiftKey}, kZKey);
  EXPECT_TRUE(target_is_at(before_um + up_um));
  // The entry takes the line with it, as long as it was.
  const InjectionPlan plan = *console_->plan();
  drag(plan.entry_um.eigen().head<2>(), plan.entry_um.eigen().head<2>() - up_um);
  EXPECT_TRUE(target_is_at(before_um));
  // The depth stop stays on the line.
  const Eigen::Vector2d axis = console_->plan()->axis.eigen().head<2>(),
                        entry_um = console_->plan()->entry_um.eigen().head<2>();
  const double stop_um = console_->depth_stop_um();
  drag(entry_um + stop_um * axis, entry_um + (stop_um - 7.0) * axis + Eigen::Vector2d(0.0, 5.0));
  EXPECT_TRUE(pass_until([&] { return std::abs(console_->depth_stop_um() - stop_um + 7.0) < 1.5; }));
  // A target outside the cell is refused, and nothing to undo.
  const Eigen::Vector2d kept_um = target_um();
  drag(kept_um, kept_um + Eigen::Vector2d(0.0, -60.0));
  EXPECT_TRUE(pass_until([&] { return label_text(*window_, "notice").find("outside") != std::string::npos; }))
      << label_text(*window_, "notice");
  EXPECT_EQ(target_um(), kept_um);
  input_.tap('p');
  EXPECT_TRUE(pass_until([&] { return !feed().plan(); }));
  input_.tap('p');
  EXPECT_TRUE(pass_until([&] { return feed().plan().has_value(); }));
}

TEST_F(GuideControlsTest, CtrlAndAClickSetTheTarget) {
  open();
  wait_for_plan();
  const Eigen::Vector2d before_um = target_um();
  input_.key(kControlKey, true);
  move_to(before_um + Eigen::Vector2d(6.0, 6.0));
  input_.left_button(true);
  pass(50);
  input_.left_button(false);
  input_.key(kControlKey, false);
  EXPECT_TRUE(pass_until([&] { return (target_um() - before_um - Eigen::Vector2d(6.0, 6.0)).norm() < 1.5; }));
  EXPECT_EQ(state(), kReady);
}

TEST_F(GuideControlsTest, CellsHaveNamesAnOutcomeAndATable) {
  open();
  wait_for_plan();
  // The next name is offered; typing one moves nothing.
  tap_with({test::kShiftKey}, kNKey);
  auto* name = named<QLineEdit>("cellName");
  ASSERT_TRUE(pass_until([&] { return name->hasFocus(); }));
  EXPECT_EQ(name->text(), "A-1");
  input_.tap(kDKey);
  input_.key(kDKey, true);
  pass(400);
  EXPECT_EQ(console_->status().tick.buttons & kInject, 0U);
  input_.key(kDKey, false);
  pass(200);
  name->setText("oocyte 09");
  input_.tap(kEnterKey);
  ASSERT_TRUE(pass_until([&] { return has_event(std::string(kCellNameNote) + "oocyte 09"); }));
  EXPECT_FALSE(name->hasFocus());
  console_->new_cell();
  ASSERT_TRUE(pass_until([&] { return has_event(std::string(kNewCellNote)); }));
  EXPECT_TRUE(pass_until([&] { return name->text() == "oocyte 10"; }));
  input_.tap(kEKey);
  ASSERT_TRUE(pass_until([&] { return is_shown("cellDrawer"); }));
  auto* list = named<QTreeWidget>("cells");
  ASSERT_TRUE(pass_until([&] { return list->topLevelItemCount() >= 2; }));
  EXPECT_EQ(list->topLevelItem(0)->text(0), "oocyte 09");
  EXPECT_EQ(list->topLevelItem(0)->text(1), "not touched");
  keep_picture(*window_, "guide-cells");
  named<QPushButton>("saveCells")->click();
  std::string table;
  for (const auto& file : std::filesystem::directory_iterator(home_ / "Pellucida")) {
    if (file.path().extension() == ".csv") table = test::text_of(file.path());
  }
  EXPECT_NE(table.find(",oocyte 09\n"), std::string::npos) << table;
}

TEST_F(GuideControlsTest, TheRecordingsFolderIsChosenBesideTheRunAndKept) {
  open();
  input_.tap(kEKey);
  ASSERT_TRUE(pass_until([&] { return is_shown("cellDrawer"); }));
  named<QPushButton>("chooseFolder")->click();
  auto* dialog = named<QFileDialog>("folderDialog");
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->isModal());
  const QString folder = QString::fromStdString((home_ / "elsewhere").string());
  dialog->fileSelected(folder);
  dialog->close();
  ASSERT_TRUE(activate(*window_)) << "not active";
  pass(300);
  named<QPushButton>("record")->click();
  ASSERT_TRUE(pass_until([&] { return run_->status().recorded_count > 0; }));
  EXPECT_TRUE(QString::fromStdString(run_->status().recording_folder).startsWith(folder));
  // The next window has it.
  const auto later = window_without_a_hand();
  EXPECT_EQ(later->findChild<QLabel*>("recordingsFolder")->toolTip(), folder);
}

TEST_F(GuideControlsTest, ADiskThatRefusesIsSaidLargeWithItsRemedyUntilItIsClosed) {
  open();
  test::put(home_ / "Pellucida", "no folder");
  named<QPushButton>("record")->click();
  ASSERT_TRUE(is_shown("problemStrip"));
  const std::string text = named<QWidget>("problemStrip")->accessibleName().toStdString();
  EXPECT_NE(text.find("can't be"), std::string::npos) << text;
  EXPECT_NE(text.find("Cells (E)"), std::string::npos) << text;
  EXPECT_EQ(text.find("--"), std::string::npos) << "no option of a command line: " << text;
  EXPECT_FALSE(run_->status().recording);
  pass(300);
  keep_picture(*window_, "guide-problem");
  named<QWidget>("problemStrip")->findChild<QPushButton*>()->click();
  EXPECT_FALSE(is_shown("problemStrip"));
}

TEST_F(GuideControlsTest, TheTruthStandsBesideTheForceOnDemand) {
  open();
  wait_for_plan();
  EXPECT_FALSE(is_shown("forceTruth"));
  input_.tap(kUKey);
  EXPECT_TRUE(pass_until([&] { return label_text(*window_, "forceTruth") == "true 0.00"; }))
      << label_text(*window_, "forceTruth");
  EXPECT_TRUE(is_shown("forceTruth"));
  EXPECT_EQ(label_text(*window_, "tipPlane").substr(0, 2), "z ");
  input_.tap(kUKey);
  EXPECT_TRUE(pass_until([&] { return !is_shown("forceTruth"); }));
}

TEST_F(GuideControlsTest, BrightnessAndContrastChangeThePictureAlone) {
  open();
  wait_for_plan();
  const auto brightness = [&] { return window_->grab(QRect(20, 500, 200, 100)).toImage(); };
  const QImage before = brightness();
  named<QSlider>("brightness")->setValue(60);
  EXPECT_DOUBLE_EQ(feed().image_look().brightness, 0.6);
  pass(300);
  const auto mean = [](const QImage& image) {
    double sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) sum += qGray(image.pixel(x, y));
    }
    return sum / (image.width() * image.height());
  };
  EXPECT_GT(mean(brightness()), mean(before) + 20.0);
  named<QSlider>("contrast")->setValue(20);
  EXPECT_DOUBLE_EQ(feed().image_look().contrast, 2.0);
  window_->findChild<QAction*>("imageFollows")->setChecked(false);
  EXPECT_FALSE(feed().image_look().follows);
}

// What a person can act on: with the keyboard alone, and told by a screen reader.
TEST_F(GuideControlsTest, EveryControlIsReachedByTabAndHasAName) {
  open();
  input_.tap(kEKey);
  tap_with({test::kShiftKey}, kNKey);
  ASSERT_TRUE(pass_until([&] { return is_shown("cellDrawer") && is_shown("recordStrip"); }));
  std::set<const QWidget*> reached;
  for (QWidget* one = window_->nextInFocusChain(); one != window_.get(); one = one->nextInFocusChain()) {
    if ((one->focusPolicy() & Qt::TabFocus) != 0) reached.insert(one);
  }
  int count = 0;
  for (auto* one : window_->findChildren<QWidget*>()) {
    const auto* button = qobject_cast<QAbstractButton*>(one);
    const bool is_control = button || qobject_cast<QComboBox*>(one) || qobject_cast<QDoubleSpinBox*>(one) ||
                            (qobject_cast<QLineEdit*>(one) && !qobject_cast<QAbstractSpinBox*>(one->parentWidget()));
    if (!is_control || !one->isVisible()) continue;
    ++count;
    const QString name = one->accessibleName().isEmpty() && button ? button->text() : one->accessibleName();
    const std::string which = (one->objectName() + " " + name + " " + one->toolTip()).toStdString();
    EXPECT_GT(name.size(), 1) << which;
    EXPECT_TRUE(reached.contains(one)) << which;
  }
  EXPECT_GT(count, 25);
}

}  // namespace
}  // namespace pellucida
