#pragma once
#include <vtkNew.h>

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <cstdint>
#include <memory>

#include "TimedScreenshot.h"
#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/ui/Guide.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "presenters/SceneFeed.h"
#include "presenters/StatusPresenter.h"

class QSplitter;

namespace pellucida {

class FeedPanel;
class ForceCharts;
class HandControl;
class MembranePanel;
class ReadoutBar;
class RunControl;
class StatusLine;
class TopBar;

/// The workstation's window in Guide mode: feed and 3-D membranes side by side, force curves below, the figures on top.
/// One timer polls the run. A tick with a new scene shows that scene everywhere, and nothing newer anywhere.
class GuideWindow : public QMainWindow {
 public:
  /// `console`: the hand on that run; nullptr: none.
  GuideWindow(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, GuideOptions options);
  ~GuideWindow() override;

  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }

 private:
  void build();
  TopBar* build_top_bar();
  QSplitter* build_views();

  void tick();
  void show_scene();
  void show_status();
  void notify(const QString& text, bool problem);
  double now_s() const;

  std::unique_ptr<LiveRun> run_;
  std::unique_ptr<OperatorConsole> console_;
  GuideOptions options_;
  vtkNew<StageSource> source_;
  SceneFeed scenes_;
  FeedView feed_{source_};
  MembraneView membranes_{source_};
  StatusPresenter status_;

  std::unique_ptr<RunControl> control_;
  std::unique_ptr<HandControl> hand_;
  TopBar* top_bar_ = nullptr;
  ReadoutBar* readouts_ = nullptr;
  FeedPanel* feed_panel_ = nullptr;
  MembranePanel* membrane_panel_ = nullptr;
  ForceCharts* charts_ = nullptr;
  StatusLine* status_line_ = nullptr;

  QTimer timer_;
  QElapsedTimer clock_;
  double status_shown_s_ = -1.0;
  double notice_until_s_ = 0.0;
  std::uint64_t drawn_count_ = 0;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
