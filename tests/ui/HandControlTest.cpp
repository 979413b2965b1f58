#include "HandControl.h"

#include <gtest/gtest.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPushButton>
#include <QWheelEvent>
#include <chrono>
#include <thread>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "presenters/HandPresenter.h"
#include "ui/OffscreenWidgets.h"
#include "widgets/HandBar.h"
#include "widgets/ViewWidget.h"

namespace pellucida {
namespace {

class Widgets : public test::OffscreenWidgets {
 protected:
  static QPushButton* button(QWidget& parent, const QString& text) {
    for (auto* one : parent.findChildren<QPushButton*>()) {
      if (one->text() == text) return one;
    }
    return nullptr;
  }
};

class HandBarTest : public Widgets {
 protected:
  HandBar::Actions actions() {
    HandBar::Actions actions;
    const auto note = [this](const QString& text) { said_ << text; };
    const auto on = [](bool held) { return held ? " on" : " off"; };
    actions.choose_hand = [=](int index) { note("hand " + QString::number(index)); };
    actions.guide = [=](bool held) { note(QString("guide") + on(held)); };
    actions.choose_scale = [=](int index) { note("scale " + QString::number(index)); };
    actions.depth_stop = [=](double depth_um) { note("depth " + QString::number(depth_um)); };
    actions.inject = [=](bool held) { note(QString("inject") + on(held)); };
    actions.retract = [=](bool held) { note(QString("retract") + on(held)); };
    actions.new_cell = [=] { note("new cell"); };
    actions.stop = [=] { note("stop"); };
    actions.release_stop = [=] { note("release stop"); };
    return actions;
  }

  QStringList said_;
};

TEST_F(HandBarTest, ButtonsSayWhatIsHeldAndShownValuesSayNothing) {
  HandBar bar({"One", "Two"}, {"Coarse", "Fine"}, actions(), nullptr);
  bar.set_choice(1, 1);
  bar.set_depth_stop_um(46.0);
  EXPECT_TRUE(said_.isEmpty()) << said_.join(", ").toStdString();
  button(bar, "Deposit")->pressed();
  button(bar, "Deposit")->released();
  button(bar, "Guide")->click();
  button(bar, "New cell")->click();
  bar.findChild<QDoubleSpinBox*>()->setValue(30.0);
  EXPECT_EQ(said_, QStringList({"inject on", "inject off", "guide off", "new cell", "depth 30"}))
      << said_.join(", ").toStdString();
}

// Runs the event loop for a while.
void let_pass(int time_ms) {
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < time_ms) QApplication::processEvents(QEventLoop::AllEvents, 10);
}

// A bar whose stop is in force.
class StoppedBarTest : public HandBarTest {
 protected:
  StoppedBarTest() {
    HandStatus status;
    status.tick.hand_state = HandState::kStopped;
    bar_.show();
    bar_.show_texts(hand_texts(status));
    release_ = bar_.findChild<QPushButton*>("releaseStop");
  }

  HandBar bar_{{"One"}, {"Coarse"}, actions(), nullptr};
  QPushButton* release_ = nullptr;
};

TEST_F(HandBarTest, TheStopActsAsItsButtonGoesDownAndItsReleaseIsHiddenUntilThen) {
  HandBar bar({"One"}, {"Coarse"}, actions(), nullptr);
  bar.show();
  EXPECT_FALSE(bar.findChild<QPushButton*>("releaseStop")->isVisible());
  button(bar, "STOP")->pressed();
  EXPECT_EQ(said_, QStringList({"stop"}));
  bar.hold_release(true);
  let_pass(1500);
  EXPECT_EQ(said_, QStringList({"stop"})) << "nothing to release";
}

TEST_F(StoppedBarTest, ClicksReleaseNothing) {
  ASSERT_TRUE(release_->isVisible());
  button(bar_, "STOPPED")->click();
  button(bar_, "STOPPED")->click();
  for (int k = 0; k < 3; ++k) {
    release_->pressed();
    let_pass(150);
    release_->released();
    let_pass(150);
  }
  EXPECT_EQ(said_, QStringList({"stop", "stop"})) << said_.join(", ").toStdString();
}

TEST_F(StoppedBarTest, AReleaseHeldForASecondActsOnce) {
  release_->pressed();
  let_pass(700);
  EXPECT_TRUE(said_.isEmpty());
  let_pass(1500);
  EXPECT_EQ(said_, QStringList({"release stop"}));
  release_->released();
  EXPECT_EQ(said_, QStringList({"release stop"}));
}

// The window was busy for long: the release of the button may be waiting in its queue.
TEST_F(StoppedBarTest, ABusyWindowDoesNotTakeAShortPressForALongOne) {
  release_->pressed();
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  QApplication::processEvents();
  release_->released();
  let_pass(100);
  EXPECT_TRUE(said_.isEmpty());
}

TEST_F(HandBarTest, AWheelThatPassesOverTheBarChangesNothing) {
  HandBar bar({"One", "Two"}, {"Coarse", "Fine"}, actions(), nullptr);
  bar.set_depth_stop_um(46.0);
  QList<QWidget*> targets;
  for (auto* choice : bar.findChildren<QComboBox*>()) targets << choice;
  targets << bar.findChild<QDoubleSpinBox*>();
  ASSERT_EQ(targets.size(), 3);
  for (QWidget* target : targets) {
    QWheelEvent event({5, 5}, target->mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(target, &event);
  }
  EXPECT_TRUE(said_.isEmpty()) << said_.join(", ").toStdString();
}

TEST_F(HandBarTest, WhereTheCellIsRealThereIsNoNewOne) {
  HandBar::Actions without = actions();
  without.new_cell = {};
  HandBar bar({"One"}, {"Coarse"}, without, nullptr);
  EXPECT_FALSE(button(bar, "New cell"));
}

// The control on a real console with its 1 kHz loop; the run isn't started, since no frame is needed.
class HandControlTest : public Widgets {
 protected:
  HandControlTest() {
    window_.resize(1200, 800);
    feed_widget_->resize(600, 500);
    console_.choose(console_.find_hand("Mouse").value());
  }
  ~HandControlTest() override { control_.reset(); }

  void mouse(QEvent::Type type, const QPointF& place_px, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, place_px, button, held, Qt::NoModifier);
    QApplication::sendEvent(feed_widget_, &event);
  }
  void key(QEvent::Type type, int code, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QKeyEvent event(type, code, modifiers);
    QApplication::sendEvent(&window_, &event);
  }
  bool wait_for(const std::function<bool(const HapticRecord&)>& condition) {
    for (int k = 0; k < 3000; ++k) {
      control_->tick();
      if (condition(console_.status().tick)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  bool wait_for(HandState state) {
    return wait_for([state](const HapticRecord& tick) { return tick.hand_state == state; });
  }

  VirtualInjectionSetup setup_{"injection"};
  LiveRun run_{setup_.make_microscope(Pace::kWallClock), {}};
  OperatorConsole console_{run_, setup_.injector(), &setup_.needle()};
  vtkNew<StageSource> source_;
  FeedView feed_{source_};
  QWidget window_;
  ViewWidget* feed_widget_ = new ViewWidget(feed_, 0, nullptr);
  std::unique_ptr<ViewWidget> owner_{feed_widget_};
  std::unique_ptr<HandControl> control_ = std::make_unique<HandControl>(console_, *feed_widget_, window_);
};

TEST_F(HandControlTest, TheLeftButtonHeldOnTheFeedLeadsTheNeedle) {
  ASSERT_TRUE(wait_for(HandState::kClutched));
  const double start_um = console_.status().tick.tip_um.x;
  mouse(QEvent::MouseButtonPress, {300, 200}, Qt::LeftButton, Qt::LeftButton);
  ASSERT_TRUE(wait_for(HandState::kWorking));
  mouse(QEvent::MouseMove, {250, 200}, Qt::NoButton, Qt::LeftButton);
  // 50 px of 0.1 mm each, 2 um of the tip for a mm.
  EXPECT_TRUE(wait_for([=](const HapticRecord& tick) { return tick.tip_um.x < start_um - 8.0; }));
  mouse(QEvent::MouseButtonRelease, {250, 200}, Qt::LeftButton, Qt::NoButton);
  EXPECT_TRUE(wait_for(HandState::kClutched));
  EXPECT_NEAR(console_.status().tick.tip_um.x, start_um - 10.0, 2.0);
}

TEST_F(HandControlTest, OtherButtonsAreLeftToTheView) {
  ASSERT_TRUE(wait_for(HandState::kClutched));
  mouse(QEvent::MouseButtonPress, {300, 200}, Qt::RightButton, Qt::RightButton);
  mouse(QEvent::MouseMove, {200, 200}, Qt::NoButton, Qt::RightButton);
  for (int k = 0; k < 10; ++k) control_->tick();
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kClutched);
}

TEST_F(HandControlTest, KeysActWhileHeld) {
  ASSERT_TRUE(wait_for(HandState::kClutched));
  const auto deposits = [](const HapticRecord& tick) { return (tick.buttons & kInject) != 0; };
  key(QEvent::KeyPress, Qt::Key_D);
  EXPECT_TRUE(wait_for(deposits));
  key(QEvent::KeyRelease, Qt::Key_D);
  EXPECT_TRUE(wait_for([&](const HapticRecord& tick) { return !deposits(tick); }));
  key(QEvent::KeyPress, Qt::Key_X);
  EXPECT_TRUE(wait_for([](const HapticRecord& tick) { return (tick.buttons & kRetract) != 0; }));
  // Another window comes to the front: the release of the key would go there.
  QEvent gone(QEvent::WindowDeactivate);
  QApplication::sendEvent(&window_, &gone);
  EXPECT_TRUE(wait_for([](const HapticRecord& tick) { return (tick.buttons & kRetract) == 0; }));
}

TEST_F(HandControlTest, EscapeStopsAndOnlyShiftEscapeHeldReleases) {
  ASSERT_TRUE(wait_for(HandState::kClutched));
  key(QEvent::KeyPress, Qt::Key_Escape);
  ASSERT_TRUE(wait_for(HandState::kStopped));
  key(QEvent::KeyPress, Qt::Key_Escape);
  control_->show_status();
  EXPECT_TRUE(button(*control_->bar(), "STOPPED"));
  const std::uint64_t ticks = console_.status().tick_count;
  ASSERT_TRUE(wait_for([&](const HapticRecord&) { return console_.status().tick_count > ticks + 5; }));
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kStopped);
  // Tapped, Shift+Esc releases nothing; held, it does.
  for (int k = 0; k < 3; ++k) {
    key(QEvent::KeyPress, Qt::Key_Escape, Qt::ShiftModifier);
    let_pass(150);
    key(QEvent::KeyRelease, Qt::Key_Escape, Qt::ShiftModifier);
    let_pass(150);
  }
  control_->tick();
  EXPECT_EQ(console_.status().tick.hand_state, HandState::kStopped);
  key(QEvent::KeyPress, Qt::Key_Escape, Qt::ShiftModifier);
  let_pass(1500);
  EXPECT_TRUE(wait_for(HandState::kClutched));
}

TEST_F(HandControlTest, TheDemonstrationsButtonsAreItsOwn) {
  console_.choose(console_.find_hand("Demonstration").value());
  control_->show_status();
  EXPECT_FALSE(button(*control_->bar(), "Deposit")->isEnabled());
  EXPECT_TRUE(button(*control_->bar(), "New cell")->isEnabled());
}

}  // namespace
}  // namespace pellucida
