// The real window in Review mode on an X server, with mouse and keys as a person uses them.
#include "ReviewWindow.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMimeData>
#include <QMouseEvent>
#include <QShortcut>
#include <QTreeWidget>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "NodeReview.h"
#include "ReviewViews.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/core_vtk/SceneData.h"
#include "pellucida/session/SessionWriter.h"
#include "pellucida/visualization/Readout.h"
#include "support/Files.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "visualization/SyntheticScene.h"
#include "widgets/CurvePanel.h"
#include "widgets/EventPanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/NodePanel.h"
#include "widgets/TimelineBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

constexpr long kFrames = 30;
constexpr double kStep_s = 0.1;

double indentation_of(long frame) {
  return frame < 5 ? 0.0 : 0.8 * static_cast<double>(frame - 4);
}

// Thirty frames, ten a second: five free, then a touch that goes deeper.
void write_touch(const std::filesystem::path& folder, bool close = true) {
  SessionInfo info;
  info.source.name = "synthetic";
  info.source.width_px = 728;
  info.source.height_px = 486;
  info.source.pixel_size_um = 0.825;
  info.source.pixel_size_origin = "scenario";
  info.source.frame_rate_hz = 1.0 / kStep_s;
  info.source.frame_rate_origin = "scenario";
  info.profile_name = "mouse-oocyte";
  SessionWriter writer(folder, info);
  for (long frame = 0; frame < kFrames; ++frame) {
    Scene scene = test::synthetic_scene(indentation_of(frame), frame);
    scene.measurement.frame = frame;
    scene.measurement.time_s = kStep_s * static_cast<double>(frame);
    scene.measurement.state = frame < 5 ? CellState::kFree : CellState::kContact;
    for (auto* part : {&scene.membranes, &scene.tools, &scene.surface}) {
      auto own = vtkSmartPointer<vtkPolyData>::New();
      own->DeepCopy(part->shallow_copy());
      stamp(own, scene.measurement.time_s, frame);
      *part = Frozen<vtkPolyData>(own);
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(scene.frame.shallow_copy());
    stamp(image, scene.measurement.time_s, frame);
    scene.frame = Frozen<vtkImageData>(image);
    writer.write(scene);
  }
  writer.event({0.5, "contact", "first touch"});
  writer.event({2.0, "note", "<b>bold</b>"});
  if (close) writer.close();
}

class ReviewWindowTest : public test::DisplayTest {
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
    choice.session = [this] { return answer_; };
    choice.may_replace = [this](const std::vector<std::filesystem::path>&) {
      ++questions_;
      return replace_;
    };
    choice.show_page = [this](const std::filesystem::path& page) { pages_.push_back(page); };
    window_ = std::make_unique<ReviewWindow>(ReviewOptions{}, clock_, choice);
    window_->show();
    window_->activateWindow();
  }

  static void pass(int time_ms) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < time_ms) QApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  static bool pass_until(const std::function<bool()>& condition) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 60000) {
      if (condition()) return true;
      pass(10);
    }
    return false;
  }
  bool shows(std::size_t step) {
    return pass_until([&] { return window_->shown_step() == step; });
  }
  void open() {
    window_->open(*folder_ / "S");
    ASSERT_TRUE(pass_until([&] { return window_->shown_step() == 0U; })) << text("problem");
    ASSERT_TRUE(pass_until([] { return qApp->applicationState() == Qt::ApplicationActive; }));
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

  static std::unique_ptr<TemporaryFolder> folder_;
  test::XInput input_;
  std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  std::filesystem::path answer_;
  std::vector<std::filesystem::path> proposals_, pages_;
  int questions_ = 0;
  bool replace_ = false;
  std::unique_ptr<ReviewWindow> window_;
};

std::unique_ptr<TemporaryFolder> ReviewWindowTest::folder_;

TEST_F(ReviewWindowTest, OpensASessionAndShowsItsFacts) {
  open();
  EXPECT_NE(text("facts").find("30 frames"), std::string::npos) << text("facts");
  EXPECT_NE(text("facts").find("complete"), std::string::npos);
  EXPECT_EQ(text("sourceName"), "S");
  EXPECT_EQ(window_->findChild<QTreeWidget*>("events")->topLevelItemCount(), 2);
  EXPECT_EQ(text("profile"), "mouse-oocyte");
}

TEST_F(ReviewWindowTest, KeysStepThroughTheRecordedRows) {
  open();
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(1));
  input_.key(test::kShiftKey, true);
  input_.tap(test::kRightKey);
  input_.key(test::kShiftKey, false);
  ASSERT_TRUE(shows(11));
  const Measurement& row = window_->session()->rows[11];
  EXPECT_EQ(text("force"), readout::force(row));
  EXPECT_EQ(text("indentation"), readout::indentation(row));
  EXPECT_NE(text("place").find("frame 11"), std::string::npos) << text("place");
  EXPECT_EQ(window_->views().source().GetScene().measurement.frame, 11);
  input_.tap(test::kLeftKey);
  ASSERT_TRUE(shows(10));
  input_.tap(test::kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  input_.tap(test::kHomeKey);
  ASSERT_TRUE(shows(0));
}

TEST_F(ReviewWindowTest, EventsAreReachedByKeysAndByAClickInTheList) {
  open();
  input_.tap(test::kPageDownKey);
  ASSERT_TRUE(shows(5));
  input_.tap(test::kPageDownKey);
  ASSERT_TRUE(shows(20));
  input_.tap(test::kPageUpKey);
  ASSERT_TRUE(shows(5));
  auto* list = window_->findChild<QTreeWidget*>("events");
  EXPECT_EQ(list->currentItem(), list->topLevelItem(0));
  click(*list->viewport(), list->visualItemRect(list->topLevelItem(1)).center());
  ASSERT_TRUE(shows(20));
}

TEST_F(ReviewWindowTest, KindsCanBeLeftOutOfTheList) {
  open();
  auto* list = window_->findChild<QTreeWidget*>("events");
  auto* panel = dynamic_cast<EventPanel*>(list->parentWidget());
  ASSERT_NE(panel, nullptr);
  panel->show_kind("contact", false);
  ASSERT_EQ(list->topLevelItemCount(), 1);
  // What a session says is text, never markup.
  EXPECT_EQ(list->topLevelItem(0)->text(2), "<b>bold</b>");
  EXPECT_EQ(list->topLevelItem(0)->toolTip(2).indexOf("<b>"), -1);
  panel->show_kind("contact", true);
  EXPECT_EQ(list->topLevelItemCount(), 2);
}

TEST_F(ReviewWindowTest, PlayingFollowsTheClockAndLeavesOutWhatIsOver) {
  open();
  input_.tap(test::kSpaceKey);
  ASSERT_TRUE(pass_until([&] { return window_->playback().playing(); }));
  clock_->set(0.25);
  ASSERT_TRUE(shows(2));
  clock_->set(1.75);
  ASSERT_TRUE(shows(17));
  EXPECT_EQ(text("force"), readout::number(recorded_uN(17), 2) + " µN");
  clock_->set(99.0);
  ASSERT_TRUE(shows(kFrames - 1));
  EXPECT_FALSE(window_->playback().playing());
}

TEST_F(ReviewWindowTest, LoopBackwardsAndSpeedHaveKeys) {
  open();
  input_.tap(test::kLKey);
  input_.tap(test::kBKey);
  input_.tap(test::kMinusKey);
  ASSERT_TRUE(pass_until([&] { return window_->playback().speed_ratio() == 0.5; }));
  EXPECT_TRUE(window_->playback().loop());
  EXPECT_TRUE(window_->playback().backwards());
  input_.tap(test::kSpaceKey);
  ASSERT_TRUE(pass_until([&] { return window_->playback().playing(); }));
  // From the end, at half the speed.
  clock_->set(1.1);
  ASSERT_TRUE(shows(23));
}

TEST_F(ReviewWindowTest, TheTimelineSeeksByPressAndDrag) {
  open();
  TimelineBar& bar = timeline();
  const auto place = [&](double time_s) { return QPointF(bar.x_of(time_s), bar.bar().center().y()).toPoint(); };
  click(bar, place(1.04));
  ASSERT_TRUE(shows(10));
  EXPECT_DOUBLE_EQ(bar.position_s(), 1.0);
  click(bar, place(1.04), place(2.54) - place(1.04));
  ASSERT_TRUE(shows(25));
}

TEST_F(ReviewWindowTest, TheTimeChartSeeksAndItsCursorFollows) {
  open();
  auto& views = const_cast<ReviewViews&>(window_->views());
  CurvePanel& chart = views.force_over_time();
  ASSERT_TRUE(pass_until([&] { return chart.chart().x_at(0.0).has_value(); }));
  int x_px = 0;
  while (*chart.chart().x_at(x_px) < 1.55) ++x_px;
  click(chart.view(), QPoint(x_px, chart.view().height() / 2));
  ASSERT_TRUE(shows(15));
  EXPECT_DOUBLE_EQ(chart.chart().cursor_x(), 1.5);
  EXPECT_NEAR(chart.chart().cursor_y(), recorded_uN(15), 1e-9);
  EXPECT_NEAR(views.force_over_indentation().chart().cursor_x(), indentation_of(15), 1e-6);
  EXPECT_EQ(chart.chart().data().curve.x.size(), static_cast<std::size_t>(kFrames));
}

TEST_F(ReviewWindowTest, AClickOnTheMembranePicksANodeAndReadsItsHistory) {
  open();
  input_.tap(test::kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  auto& views = const_cast<ReviewViews&>(window_->views());
  ViewWidget& view = views.membranes().view();
  // A drag turns the view and picks nothing.
  click(view, view.rect().center(), {40, 0});
  EXPECT_FALSE(window_->node().node());
  click(view, view.rect().center());
  ASSERT_TRUE(pass_until([&] { return window_->node().node().has_value(); }));
  auto& panel = const_cast<NodeReview&>(window_->node()).panel();
  ASSERT_TRUE(pass_until([&] { return panel.curve().chart().data().curve.size() > 0; }));
  const long node = *window_->node().node();
  const auto surface = window_->views().source().GetScene().surface.shallow_copy();
  const double now_uN = surface_node(surface, node)->force_magnitude_uN;
  const Curve& force = panel.curve().chart().data().curve;
  EXPECT_NEAR(force.x.back(), kStep_s * (kFrames - 1), 1e-9);
  EXPECT_NEAR(force.y.back(), now_uN, 1e-9);
  panel.choose_meridian(true);
  const CurveChartData& meridian = panel.curve().chart().data();
  EXPECT_NE(meridian.x_title.find("Angle"), std::string::npos);
  panel.choose_meridian(false);
  panel.choose_array(NodeArray::kDisplacement);
  EXPECT_NE(panel.curve().chart().data().y_title.find("Displacement"), std::string::npos);
}

TEST_F(ReviewWindowTest, ABadSessionIsASentenceAndTheWindowStaysUsable) {
  window_->open("/no/such/folder");
  ASSERT_TRUE(pass_until([&] { return text("problem").find("no such session folder") != std::string::npos; }));
  EXPECT_EQ(window_->session(), nullptr);
  input_.tap(test::kSpaceKey);
  input_.tap(test::kRightKey);
  pass(100);
  open();
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(1));
  // With a session at hand, it stays.
  window_->open("/no/such/folder");
  ASSERT_TRUE(pass_until([&] { return text("notice").find("no such session folder") != std::string::npos; }));
  EXPECT_NE(window_->session(), nullptr);
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(2));
}

TEST_F(ReviewWindowTest, ADamagedFrameSaysSoAndSteppingGoesOn) {
  write_touch(*folder_ / "damaged", false);
  test::put(*folder_ / "damaged" / "surface" / "surface_00000001.vtp", "broken");
  window_->open(*folder_ / "damaged");
  ASSERT_TRUE(shows(0));
  EXPECT_NE(text("facts").find("interrupted"), std::string::npos);
  EXPECT_NE(text("notice").find("interrupted"), std::string::npos);
  ASSERT_TRUE(pass_until([] { return qApp->applicationState() == Qt::ApplicationActive; }));
  pass(100);
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(1));
  // Once the first notice has been there for its time.
  EXPECT_TRUE(pass_until([&] { return text("notice").find("surface_00000001") != std::string::npos; }))
      << text("notice");
  input_.tap(test::kRightKey);
  ASSERT_TRUE(shows(2));
  EXPECT_TRUE(pass_until([&] { return text("notice").find("surface_00000001") == std::string::npos; }));
}

TEST_F(ReviewWindowTest, AFolderDroppedOnTheWindowIsOpened) {
  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile(QString::fromStdString((*folder_ / "S").string()))});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &drop);
  EXPECT_TRUE(shows(0));
}

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

TEST_F(ReviewWindowTest, NoKeyIsGivenTwiceAndTipsNameTheKeys) {
  open();
  std::map<QString, int> uses;
  int named = 0;
  for (const auto* shortcut : window_->findChildren<QShortcut*>()) {
    ++uses[shortcut->key().toString()];
    const auto* button = qobject_cast<const QAbstractButton*>(shortcut->parent());
    if (!button) continue;
    ++named;
    EXPECT_TRUE(button->toolTip().endsWith("(" + shortcut->key().toString() + ")")) << button->toolTip().toStdString();
  }
  for (const auto* button : window_->findChildren<QAbstractButton*>()) ++uses[button->shortcut().toString()];
  for (const auto* action : window_->findChildren<QAction*>()) {
    for (const QKeySequence& key : action->shortcuts()) ++uses[key.toString()];
  }
  uses.erase(QString());
  for (const auto& [key, count] : uses) EXPECT_EQ(count, 1) << key.toStdString();
  EXPECT_GT(named, 18);
  for (const char* key : {"Space", "Left", "Shift+Left", "Home", "End", "PgUp", "PgDown", "L", "B", "Ctrl+O"}) {
    EXPECT_TRUE(uses.contains(key)) << key;
  }
}

}  // namespace
}  // namespace pellucida
