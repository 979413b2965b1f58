// The real window in Review mode on an X server, with mouse and keys as a person uses them.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDropEvent>
#include <QMimeData>
#include <QShortcut>
#include <QTreeWidget>
#include <QUrl>
#include <map>

#include "NodeReview.h"
#include "ReviewViews.h"
#include "Translation.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "review/ReviewWindowFixture.h"
#include "support/Files.h"
#include "widgets/CurvePanel.h"
#include "widgets/EventPanel.h"
#include "widgets/MembranePanel.h"
#include "widgets/NodePanel.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

using namespace test;

TEST_F(ReviewWindowTest, OpensASessionAndShowsItsFacts) {
  open();
  EXPECT_NE(text("facts").find("30 frames"), std::string::npos) << text("facts");
  EXPECT_NE(text("facts").find("complete"), std::string::npos);
  EXPECT_EQ(text("sourceName"), "S");
  EXPECT_EQ(window_->findChild<QTreeWidget*>("events")->topLevelItemCount(), 2);
  EXPECT_EQ(text("profile"), "mouse-oocyte");
  const auto* profile = window_->findChild<QLabel*>("profile");
  EXPECT_GE(profile->width(), profile->sizeHint().width()) << "cut off";
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

struct SpeaksGerman {
  Translation german{"de"};
};
// The language is there before the window.
class GermanReviewWindowTest : SpeaksGerman, public ReviewWindowTest {};

TEST_F(GermanReviewWindowTest, EventsAndErrorsAreGermanAndTheSessionIsNot) {
  window_->open("/no/such/folder");
  EXPECT_TRUE(pass_until([&] {
    return text("problem") == "/no/such/folder: kein solcher Sitzungsordner; prüfen Sie den Pfad";
  })) << text("problem");
  open();
  auto* list = window_->findChild<QTreeWidget*>("events");
  ASSERT_EQ(list->topLevelItemCount(), 2);
  EXPECT_EQ(list->topLevelItem(0)->text(1), "Kontakt");
  EXPECT_EQ(list->topLevelItem(1)->text(1), "Notiz");
  EXPECT_EQ(list->topLevelItem(1)->text(2), "<b>bold</b>");
  EXPECT_EQ(window_->session()->events.front().kind, "contact");
  const auto* pill = window_->findChild<QLabel*>("statePill");
  EXPECT_GE(pill->width(), pill->fontMetrics().horizontalAdvance("Durchstochen") + 20) << "a state's name is cut off";
  dynamic_cast<EventPanel*>(list->parentWidget())->show_kind("contact", false);
  EXPECT_EQ(list->topLevelItemCount(), 1);
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
  ASSERT_TRUE(activate(*window_)) << "not active";
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

TEST_F(ReviewWindowTest, AnotherSessionTakesThePlaceOfTheFirst) {
  open();
  input_.tap(kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  auto& views = const_cast<ReviewViews&>(window_->views());
  click(views.membranes().view(), views.membranes().view().rect().center());
  ASSERT_TRUE(pass_until([&] { return window_->node().node().has_value(); }));
  write_touch(*folder_ / "second");
  answer_ = *folder_ / "second";
  window_->findChild<QAbstractButton*>("openSession")->click();
  ASSERT_TRUE(pass_until([&] { return text("sourceName") == "second"; }));
  ASSERT_TRUE(shows(0));
  EXPECT_FALSE(window_->node().node());
  EXPECT_FALSE(window_->findChild<QWidget*>("nodePanel")->isVisible());
}

TEST_F(ReviewWindowTest, ADamagedFrameSaysSoAndSteppingGoesOn) {
  write_touch(*folder_ / "damaged", false);
  test::put(*folder_ / "damaged" / "surface" / "surface_00000001.vtp", "broken");
  window_->open(*folder_ / "damaged");
  ASSERT_TRUE(shows(0));
  EXPECT_NE(text("facts").find("interrupted"), std::string::npos);
  EXPECT_NE(text("notice").find("interrupted"), std::string::npos);
  ASSERT_TRUE(activate(*window_)) << "not active";
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

// A session holds what each kind of arrow needs; its model's mesh it doesn't.
TEST_F(ReviewWindowTest, KeysAndMenuChooseTheForceOfTheArrowsAndTheSurfacesColour) {
  open();
  input_.tap(test::kEndKey);
  ASSERT_TRUE(shows(kFrames - 1));
  auto& views = const_cast<ReviewViews&>(window_->views());
  const auto& view = dynamic_cast<const MembraneView&>(views.membranes().view().view());
  EXPECT_EQ(view.node_force(), NodeForceKind::kTools);
  EXPECT_FALSE(view.lacks_node_force());
  EXPECT_FALSE(view.holder_label().empty());
  input_.tap(test::k7Key);
  ASSERT_TRUE(pass_until([&] { return view.node_force() == NodeForceKind::kNeedle; }));
  window_->findChild<QAbstractButton*>("nodeForce3")->click();
  EXPECT_EQ(view.node_force(), NodeForceKind::kPressure);
  EXPECT_FALSE(view.lacks_node_force());
  EXPECT_TRUE(view.holder_label().empty());
  input_.tap(test::k8Key);
  ASSERT_TRUE(pass_until([&] { return view.coloring() == SurfaceColoring::kTension; }));
  input_.tap(test::k8Key);
  ASSERT_TRUE(pass_until([&] { return view.coloring() == SurfaceColoring::kAreaStrain; }));

  auto* model = window_->findChild<QAction*>("modelSurface");
  EXPECT_FALSE(model->isEnabled());
  EXPECT_NE(model->toolTip(), model->text());
}

}  // namespace
}  // namespace pellucida
