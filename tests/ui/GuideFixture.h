#pragma once
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <memory>
#include <string>

#include "GuideWindow.h"
#include "Theme.h"
#include "pellucida/core/TemporaryFolder.h"
#include "pellucida/operation/VirtualExposure.h"
#include "pellucida/operation/VirtualInjectionSetup.h"
#include "pellucida/pipeline/AnySource.h"
#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "ui/DisplayTest.h"
#include "ui/XInput.h"
#include "widgets/ViewWidget.h"

namespace pellucida {

/// The window on the virtual microscope, the needle in the hand of mouse and keyboard; a home of its own, so that
/// nothing is read from or left in the person's.
class GuideWindowTest : public test::DisplayTest {
 protected:
  GuideWindowTest() {
    apply_theme(*qApp, dark_theme());
    qputenv("HOME", home_.path().c_str());
    qputenv("XDG_CONFIG_HOME", (home_ / "config").c_str());
    auto virtual_microscope = setup_.make_microscope(Pace::kWallClock);
    const auto truth = virtual_microscope->truth_log();
    auto microscope = with_virtual_exposure(std::move(virtual_microscope));
    const auto exposure = microscope->exposure();
    auto run = std::make_unique<LiveRun>(std::move(microscope), PipelineOptions{});
    run_ = run.get();
    auto console = std::make_unique<OperatorConsole>(*run, setup_.injector(), &setup_.needle());
    console_ = console.get();
    GuideOptions options;
    options.hand = console->find_hand("Mouse").value();
    options.true_force_uN = [truth](long frame) { return truth->force_uN(frame); };
    options.exposure = exposure;
    window_ = std::make_unique<GuideWindow>(std::move(run), std::move(console), options);
  }

  // A scenario's own motion, which can start again, and no hand.
  static std::unique_ptr<GuideWindow> window_without_a_hand() {
    auto run = std::make_unique<LiveRun>(open_any_source("virtual:default", {}), PipelineOptions{});
    return std::make_unique<GuideWindow>(std::move(run), nullptr, GuideOptions{});
  }

  static void show(QWidget& window) { ASSERT_TRUE(activate(window)) << "not active"; }

  // Shown, active, and its hand at work.
  void open() {
    show(*window_);
    ASSERT_TRUE(pass_until([&] { return state() == kReady; })) << "no hand";
    // The listener is told where the stop is with the window's next tick.
    pass(300);
  }

  static constexpr HandState kReady = HandState::kClutched;
  HandState state() { return console_->status().tick.hand_state; }

  // The window's thread is busy, as with a long rendering: no event is seen. How long until the hand is stopped, ms.
  double busy_until_stopped_ms() {
    QElapsedTimer clock;
    clock.start();
    while (state() != HandState::kStopped && clock.elapsed() < 5000) {
    }
    return 1e-6 * static_cast<double>(clock.nsecsElapsed());
  }

  void point_at(const QWidget& widget) {
    const QPoint place = widget.mapToGlobal(widget.rect().center());
    input_.move(place.x(), place.y());
  }
  QPushButton& stop() { return *window_->findChild<QPushButton*>("emergencyStop"); }
  QPushButton& release() { return *window_->findChild<QPushButton*>("releaseStop"); }
  void hold_release() {
    ASSERT_TRUE(pass_until([&] { return release().isVisible(); }));
    pass(100);
    point_at(release());
    input_.left_button(true);
    EXPECT_TRUE(pass_until([&] { return state() == kReady; }));
    input_.left_button(false);
    pass(100);
  }

  TemporaryFolder home_;
  test::XInput input_;
  VirtualInjectionSetup setup_{"injection"};
  LiveRun* run_ = nullptr;
  OperatorConsole* console_ = nullptr;
  std::unique_ptr<GuideWindow> window_;
};

/// The image's place of a point, on the screen.
inline QPoint on_screen(GuideWindow& window, const Eigen::Vector2d& place_um) {
  ViewWidget* view = nullptr;
  FeedView* found = nullptr;
  for (auto* widget : ViewWidget::all_in(window)) {
    if (auto* image = dynamic_cast<FeedView*>(&widget->view())) {
      view = widget;
      found = image;
    }
  }
  FeedView& feed = *found;
  const double height_px = view->height();
  // The view is linear: where two places lie tells where all do.
  const Eigen::Vector2d origin_um = feed.place_um(0.0, 0.0, height_px);
  const Eigen::Vector2d per_px = (feed.place_um(100.0, 100.0, height_px) - origin_um) / 100.0;
  const Eigen::Vector2d place_px = (place_um - origin_um).cwiseQuotient(per_px);
  return view->mapToGlobal(
      QPoint(static_cast<int>(std::lround(place_px.x())), static_cast<int>(std::lround(place_px.y()))));
}

inline std::string label_text(QWidget& window, const char* name) {
  const auto* label = window.findChild<QLabel*>(name);
  return label ? label->text().toStdString() : std::string("no label ") + name;
}

}  // namespace pellucida
