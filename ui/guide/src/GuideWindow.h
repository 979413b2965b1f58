#pragma once
#include <vtkNew.h>

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <cstdint>
#include <memory>

#include "ClosingQuestion.h"
#include "TimedScreenshot.h"
#include "WindowFigures.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/guide/Guide.h"
#include "pellucida/operation/DepositTracker.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "presenters/GaugePresenter.h"
#include "presenters/PunctureMemory.h"
#include "presenters/SceneFeed.h"
#include "presenters/StatusPresenter.h"

class QSplitter;

namespace pellucida {

class CellControl;
class DisplayControl;
class FeedPanel;
class ForceCharts;
class FactLine;
class GaugeBar;
class HandControl;
class HintControl;
class MembranePanel;
class MessageStrip;
class PlanControl;
class RunControl;
class StatusLine;
class TopBar;

/// The workstation's window in Guide mode: feed and 3-D membranes side by side, force curves below, the gauges on top.
/// One timer polls the run. A tick with a new scene shows that scene everywhere, and nothing newer anywhere.
class GuideWindow : public QMainWindow {
 public:
  /// `console`: the hand on that run; nullptr: none.
  GuideWindow(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, GuideOptions options);
  ~GuideWindow() override;

  const WindowFigures& figures() const noexcept { return figures_; }
  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }

  /// Ends the run for good, once the window is closed. Throws OutputError where its recording could not be closed
  /// whole.
  void end_run();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void stop_run();
  void build();
  TopBar* build_top_bar();
  QSplitter* build_views();
  QSplitter* build_rows();
  void build_controls();

  void tick();
  void show_scene();
  void show_deposits();
  void show_gauges();
  std::vector<Event> take_events();
  void give_hint(const PersonHint& hint);
  void show_status();
  void notify(const QString& text, bool problem);
  void warn(const QString& text);
  double now_s() const;

  std::unique_ptr<LiveRun> run_;
  std::unique_ptr<OperatorConsole> console_;
  GuideOptions options_;
  WindowFigures figures_{options_.figures};
  vtkNew<StageSource> source_;
  SceneFeed scenes_;
  FeedView feed_{source_};
  MembraneView membranes_{source_};
  StatusPresenter status_;

  std::unique_ptr<RunControl> control_;
  ClosingQuestion closing_;
  std::unique_ptr<HandControl> hand_;
  TopBar* top_bar_ = nullptr;
  GaugeBar* gauges_ = nullptr;
  FactLine* facts_ = nullptr;
  HintControl* hints_ = nullptr;  // the feed panel's, as the next
  PlanControl* plan_ = nullptr;   // with a hand
  CellControl* cells_ = nullptr;
  DisplayControl* display_ = nullptr;
  MessageStrip* problem_ = nullptr;
  FeedPanel* feed_panel_ = nullptr;
  MembranePanel* membrane_panel_ = nullptr;
  ForceCharts* charts_ = nullptr;
  StatusLine* status_line_ = nullptr;
  QSplitter* rows_ = nullptr;
  bool is_low_ = false;

  QTimer timer_;
  QElapsedTimer clock_;
  TipSpeed seen_speed_, reported_speed_;
  std::optional<double> seen_speed_um_per_s_;
  PunctureMemory puncture_;
  DepositTracker deposits_;
  std::size_t event_count_ = 0;  // of the run's, taken so far
  double hint_until_s_ = 0.0;    // a mark on the image
  double status_shown_s_ = -1.0;
  double notice_until_s_ = 0.0;
  std::uint64_t drawn_count_ = 0;
  std::optional<std::string> shown_fault_;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
