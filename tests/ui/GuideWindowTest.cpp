// The real window on an X server: its keys, and the emergency stop as a person uses it.
#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <numbers>

#include "Closing.h"
#include "GuideFixture.h"
#include "HandControl.h"
#include "pellucida/visualization/Readout.h"
#include "widgets/GaugeBar.h"

namespace pellucida {
namespace {

// How often each key is given: by shortcuts, buttons, actions, and to the hand.
std::map<QString, int> keys_of(const QWidget& window) {
  std::map<QString, int> uses;
  for (const auto* shortcut : window.findChildren<QShortcut*>()) ++uses[shortcut->key().toString()];
  for (const auto* button : window.findChildren<QAbstractButton*>()) ++uses[button->shortcut().toString()];
  for (const auto* action : window.findChildren<QAction*>()) {
    for (const QKeySequence& key : action->shortcuts()) ++uses[key.toString()];
  }
  for (const QKeySequence& key : HandControl::keys()) ++uses[key.toString()];
  uses.erase(QString());
  return uses;
}

TEST_F(GuideWindowTest, NoKeyIsGivenTwice) {
  const auto with_hand = keys_of(*window_), without = keys_of(*window_without_a_hand());
  EXPECT_TRUE(with_hand.contains("G"));
  EXPECT_TRUE(without.contains("Home"));
  for (const auto* keys : {&with_hand, &without}) {
    for (const auto& [key, count] : *keys) EXPECT_EQ(count, 1) << key.toStdString();
  }
}

TEST_F(GuideWindowTest, ClosingAsksOnceWhileARecordingRuns) {
  const TemporaryFolder folder;
  auto run = std::make_unique<LiveRun>(open_any_source("virtual:default", {}), PipelineOptions{});
  GuideOptions options;
  options.session_folder = (folder / "S").string();
  GuideWindow window(std::move(run), nullptr, options);
  show(window);
  auto* record = window.findChild<QPushButton*>("record");
  record->click();
  ASSERT_TRUE(pass_until([&] { return std::filesystem::exists(folder / "S"); }));
  // Those on screen: an answered one is deleted a moment later.
  const auto asked = [&] {
    QList<QWidget*> questions = window.findChildren<QWidget*>("closingQuestion");
    questions.erase(std::remove_if(questions.begin(), questions.end(), [](auto* one) { return !one->isVisible(); }),
                    questions.end());
    return questions;
  };
  // The way to the start page asks as well, and is forgotten with a no.
  close_for_start_page(window);
  ASSERT_TRUE(window.isVisible());
  ASSERT_TRUE(pass_until([&] { return asked().size() == 1; }));
  EXPECT_FALSE(asked().front()->isModal()) << "no dialog blocks a live cell";
  asked().front()->findChild<QPushButton*>("goOn")->click();
  ASSERT_TRUE(pass_until([&] { return asked().empty(); }));
  EXPECT_FALSE(leads_to_start_page(window));
  EXPECT_TRUE(record->isChecked());
  EXPECT_FALSE(window.close());
  EXPECT_FALSE(window.close());
  ASSERT_TRUE(pass_until([&] { return asked().size() == 1; }));
  keep_picture(*asked().front(), "closing-question");
  asked().front()->findChild<QPushButton*>("endAndClose")->click();
  ASSERT_TRUE(pass_until([&] { return !window.isVisible(); }));
  window.end_run();
  EXPECT_TRUE(std::filesystem::exists(folder / "S" / "session.json"));
}

TEST_F(GuideWindowTest, TipsNameTheKeys) {
  int named = 0;
  for (const auto* shortcut : window_->findChildren<QShortcut*>()) {
    const auto* button = qobject_cast<const QAbstractButton*>(shortcut->parent());
    if (!button) continue;
    ++named;
    EXPECT_TRUE(button->toolTip().endsWith("(" + shortcut->key().toString() + ")")) << button->toolTip().toStdString();
  }
  EXPECT_GT(named, 12);
  for (const QKeySequence& key : HandControl::keys()) {
    const auto buttons = window_->findChildren<QAbstractButton*>();
    EXPECT_TRUE(std::any_of(buttons.begin(), buttons.end(), [&](const QAbstractButton* button) {
      return button->toolTip().endsWith("(" + key.toString() + ")");
    })) << key.toString().toStdString();
  }
}

TEST_F(GuideWindowTest, HomeRestartsAndVResetsTheViewInThreeDimensions) {
  const auto window = window_without_a_hand();
  std::map<std::string, int> clicks;
  for (const auto* shortcut : window->findChildren<QShortcut*>()) {
    auto* button = qobject_cast<QAbstractButton*>(shortcut->parent());
    if (!button) continue;
    QObject::connect(button, &QAbstractButton::clicked, window.get(),
                     [&clicks, tip = button->toolTip().toStdString()] { ++clicks[tip]; });
  }
  show(*window);
  input_.tap(test::kHomeKey);
  input_.tap(test::kVKey);
  EXPECT_TRUE(pass_until([&] { return clicks.size() >= 2; }));
  EXPECT_EQ(clicks["Start the source again from its first frame (Home)"], 1);
  EXPECT_EQ(clicks["Back to the first point of view (V)"], 1);
  EXPECT_EQ(clicks.size(), 2U);
}

// VTK has keys of its own: P picks, S changes the surfaces, E ends the program.
TEST_F(GuideWindowTest, AViewThatHasTheFocusTakesNoKeys) {
  open();
  int keys = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&keys);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  const auto views = ViewWidget::all_in(*window_);
  ASSERT_EQ(views.size(), 4U);
  for (ViewWidget* view : views) {
    view->interactor()->AddObserver("CharEvent", count);
    view->interactor()->AddObserver("KeyPressEvent", count);
    view->setFocus();
    input_.tap(test::kPKey);
    pass(200);
  }
  EXPECT_EQ(keys, 0);
}

TEST_F(GuideWindowTest, ADoubleClickOnStopStopsAndOnlyTheHeldReleaseReleases) {
  open();
  point_at(stop());
  for (int k = 0; k < 2; ++k) {
    input_.left_button(true);
    pass(40);
    input_.left_button(false);
    pass(110);
  }
  ASSERT_TRUE(pass_until([&] { return state() == HandState::kStopped; }));
  // Nor do quick clicks on the release.
  ASSERT_TRUE(pass_until([&] { return release().isVisible(); }));
  pass(100);
  point_at(release());
  for (int k = 0; k < 2; ++k) {
    input_.left_button(true);
    pass(40);
    input_.left_button(false);
    pass(110);
  }
  pass(1200);
  EXPECT_EQ(state(), HandState::kStopped);
  hold_release();
}

TEST_F(GuideWindowTest, ShiftEscapeHeldReleasesTheStop) {
  open();
  input_.tap(test::kEscapeKey);
  ASSERT_TRUE(pass_until([&] { return state() == HandState::kStopped; }));
  input_.key(test::kShiftKey, true);
  input_.tap(test::kEscapeKey);
  pass(1300);
  EXPECT_EQ(state(), HandState::kStopped);
  input_.key(test::kEscapeKey, true);
  EXPECT_TRUE(pass_until([&] { return state() == kReady; }));
  input_.key(test::kEscapeKey, false);
  input_.key(test::kShiftKey, false);
}

// The bound: however long the window's thread is busy, Esc and STOP reach the 1 kHz loop by a thread of their own.
TEST_F(GuideWindowTest, TheStopDoesNotWaitForABusyWindow) {
  open();
  std::vector<double> key_ms, click_ms;
  for (int k = 0; k < 3; ++k) {
    input_.tap(test::kEscapeKey);
    key_ms.push_back(busy_until_stopped_ms());
    hold_release();
    point_at(stop());
    pass(100);
    input_.left_button(true);
    click_ms.push_back(busy_until_stopped_ms());
    input_.left_button(false);
    hold_release();
  }
  for (auto* all : {&key_ms, &click_ms}) {
    std::sort(all->begin(), all->end());
    std::cout << (all == &key_ms ? "Esc" : "STOP") << " to a stopped hand, window busy: median "
              << (*all)[all->size() / 2] << " ms, longest " << all->back() << " ms\n";
    // Some milliseconds; the margin is for a machine that is busy with other things.
    EXPECT_LT((*all)[all->size() / 2], 100.0);
    EXPECT_LT(all->back(), 1000.0);
  }
}

TEST_F(GuideWindowTest, AHintIsGivenByKeyAndClickAndTakenBackByAKey) {
  open();
  ASSERT_TRUE(pass_until([&] { return label_text(*window_, "statePill") == "Free"; }))
      << label_text(*window_, "statePill");
  ASSERT_TRUE(pass_until([&] { return console_->plan().has_value(); }));
  const Eigen::Vector2d cell_um = console_->plan()->cell.center_um.eigen().head<2>();
  const auto click = [&](const Eigen::Vector2d& place_um) {
    const QPoint at = on_screen(*window_, place_um);
    input_.move(at.x(), at.y());
    pass(100);
    input_.left_button(true);
    pass(50);
    input_.left_button(false);
  };
  const auto notice = [&](const char* words) {
    return pass_until([&] { return label_text(*window_, "notice").find(words) != std::string::npos; });
  };
  input_.key(test::kShiftKey, true);
  input_.tap(test::kOKey);
  input_.key(test::kShiftKey, false);
  pass(300);
  keep_picture(*window_, "guide-hint-prompt");
  click(cell_um);
  EXPECT_TRUE(notice("Hint: no cell at")) << label_text(*window_, "notice");
  EXPECT_TRUE(pass_until([&] { return label_text(*window_, "statePill") == "No cell"; }));
  // The click moved no needle.
  EXPECT_EQ(state(), kReady);
  keep_picture(*window_, "guide-no-cell");
  input_.tap(test::kBackspaceKey);
  EXPECT_TRUE(notice("taken back")) << label_text(*window_, "notice");
  EXPECT_TRUE(pass_until([&] { return label_text(*window_, "statePill") == "Free"; }));
  input_.tap(test::kOKey);
  pass(300);
  click(cell_um);
  EXPECT_TRUE(notice("found")) << label_text(*window_, "notice");
}

TEST_F(GuideWindowTest, TheCellsOutlineIsDrawnAndTheHolderPointedAt) {
  open();
  ASSERT_TRUE(pass_until([&] { return console_->plan().has_value(); }));
  const Eigen::Vector2d center_um = console_->plan()->cell.center_um.eigen().head<2>();
  const auto move_to = [&](double angle_rad, double radius_um) {
    const QPoint at =
        on_screen(*window_, center_um + radius_um * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
    input_.move(at.x(), at.y());
    pass(20);
  };
  const auto notice = [&](const char* words) {
    return pass_until([&] { return label_text(*window_, "notice").find(words) != std::string::npos; });
  };
  input_.tap(test::kKKey);
  pass(300);
  constexpr int kSteps = 40;
  for (int k = 0; k <= kSteps; ++k) {
    move_to(0.5 + 6.1 * k / kSteps, 55.0 + 3.0 * std::sin(0.7 * k));
    if (k == 0) input_.left_button(true);
    if (k == kSteps) keep_picture(*window_, "guide-hint-outline");
  }
  input_.left_button(false);
  EXPECT_TRUE(notice("Hint: cell outlined by 32 places: found")) << label_text(*window_, "notice");
  keep_picture(*window_, "guide-hint-outlined");
  // The drag moved no needle.
  EXPECT_EQ(state(), kReady);

  // A mere click is no outline.
  input_.tap(test::kKKey);
  pass(300);
  move_to(0.5, 55.0);
  input_.left_button(true);
  pass(50);
  input_.left_button(false);
  EXPECT_TRUE(notice("That was no outline")) << label_text(*window_, "notice");

  input_.key(test::kShiftKey, true);
  input_.tap(test::kHKey);
  input_.key(test::kShiftKey, false);
  pass(300);
  // The virtual cell's holder lies to its left.
  move_to(std::numbers::pi, 75.0);
  input_.left_button(true);
  pass(50);
  input_.left_button(false);
  EXPECT_TRUE(notice("Hint: holding pipette at")) << label_text(*window_, "notice");
  EXPECT_NE(label_text(*window_, "notice").find("followed"), std::string::npos) << label_text(*window_, "notice");
}

std::vector<GaugeBox*> gauges(QWidget& window) {
  std::vector<GaugeBox*> boxes;
  for (QFrame* frame : window.findChildren<QFrame*>("gaugeBox")) boxes.push_back(dynamic_cast<GaugeBox*>(frame));
  return boxes;
}

TEST_F(GuideWindowTest, TheGaugesShowTheLimitsOfHandAndPlan) {
  open();
  ASSERT_TRUE(pass_until([&] { return console_->plan().has_value(); }));
  EXPECT_TRUE(pass_until([&] {
    const auto boxes = gauges(*window_);
    return boxes.size() == 4 && boxes[3]->gauge().value.find("µm") != std::string::npos &&
           boxes[0]->gauge().limit == "limit " + readout::number(console_->limits().max_force_uN, 1) + " µN";
  }));
  for (const auto& size : {QSize(1400, 900), QSize(1000, 640)}) {
    window_->resize(size);
    pass(400);
    for (const GaugeBox* box : gauges(*window_)) {
      EXPECT_TRUE(box->isVisible());
      for (const QLabel* label : box->findChildren<QLabel*>()) {
        if (!label->isVisible()) continue;
        EXPECT_TRUE(box->rect().contains(label->geometry())) << label->text().toStdString();
        EXPECT_GE(label->height(), label->fontMetrics().height())
            << label->text().toStdString() << " at " << size.width();
        EXPECT_LE(label->fontMetrics().horizontalAdvance(label->text()), label->width())
            << label->text().toStdString() << " at " << size.width();
      }
    }
    keep_picture(*window_, size.width() == 1400 ? "guide-1400" : "guide-1000");
    // The scale has its place at every size.
    EXPECT_TRUE(window_->findChild<QWidget*>("scaleGauge")->isVisible()) << size.width();
  }
}

TEST_F(GuideWindowTest, ClicksBesideTheStopAndOnWhatCoversItDoNotStop) {
  open();
  const QPoint beside = stop().mapToGlobal(QPoint(stop().width() / 2, -6));
  input_.move(beside.x(), beside.y());
  pass(50);
  input_.left_button(true);
  input_.left_button(false);
  pass(300);
  EXPECT_EQ(state(), kReady);
  // Something lies over the stop.
  QWidget cover(nullptr, Qt::Tool | Qt::FramelessWindowHint);
  cover.setGeometry(QRect(stop().mapToGlobal(QPoint(-20, -20)), QSize(180, 100)));
  cover.show();
  cover.raise();
  pass(300);
  point_at(stop());
  input_.left_button(true);
  input_.left_button(false);
  pass(300);
  EXPECT_EQ(state(), kReady);
}

}  // namespace
}  // namespace pellucida
