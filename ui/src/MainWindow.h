#pragma once
#include <vtkNew.h>

#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <exception>
#include <memory>
#include <optional>

#include "pellucida/core_vtk/StageSource.h"
#include "pellucida/ui/Workstation.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/ForceChart.h"
#include "pellucida/visualization_vtk/MembraneView.h"
#include "presenters/RecordingPresenter.h"
#include "presenters/StatusPresenter.h"

class QLabel;
class QLayout;
class QPushButton;
class QSplitter;

namespace pellucida {

class HandControl;
class Panel;
class ReadoutBar;
class ViewWidget;

/// The workstation's window in Guide mode: feed and 3-D membranes side by side, force curves below, the figures on top.
/// One timer polls the run; views are rendered only when there is something new.
class MainWindow : public QMainWindow {
 public:
  /// `console`: the hand on that run; nullptr: none.
  MainWindow(std::unique_ptr<LiveRun> run, std::unique_ptr<OperatorConsole> console, WindowOptions options);
  ~MainWindow() override;

  /// What went wrong with the screenshot that was asked for, if it did.
  std::exception_ptr screenshot_fault() const { return screenshot_fault_; }

 private:
  void build();
  QWidget* build_top_bar();
  QWidget* build_status_line();
  QWidget* build_feed_panel();
  QWidget* build_membrane_panel();
  QSplitter* build_charts();
  void add_coloring_menu(Panel* panel);
  void add_shortcuts();
  QPushButton* add_top_button(QLayout* row, const QString& text, const QString& tip);

  void tick();
  bool poll_scene();
  void poll_rows();
  void show_status();
  void toggle_recording();
  void toggle_pause();
  void restart_source();
  void repeat_when_ended(const LiveStatus& status, double now_s);
  void ask_for_note();
  void save_picture();
  void finish_with_screenshot();
  void notify(const QString& text, bool problem);
  void render_views();

  std::unique_ptr<LiveRun> run_;
  std::unique_ptr<OperatorConsole> console_;
  WindowOptions options_;
  vtkNew<StageSource> source_;
  FeedView feed_{source_};
  MembraneView membranes_{source_};
  ForceChart force_indentation_{ForceChartKind::kForceIndentation};
  ForceChart force_time_{ForceChartKind::kForceTime};
  StatusPresenter status_;
  RecordingPresenter recordings_;

  std::unique_ptr<HandControl> hand_;
  ViewWidget* feed_widget_ = nullptr;
  ViewWidget* membrane_widget_ = nullptr;
  ViewWidget* force_indentation_widget_ = nullptr;
  ViewWidget* force_time_widget_ = nullptr;
  ReadoutBar* readouts_ = nullptr;
  QPushButton* record_ = nullptr;
  QPushButton* pause_ = nullptr;
  QLabel* notice_ = nullptr;
  QLabel* frame_age_ = nullptr;
  QLabel* frame_rate_ = nullptr;
  QLabel* lost_ = nullptr;
  QLabel* recording_ = nullptr;

  QTimer timer_;
  QElapsedTimer clock_;
  double charts_shown_s_ = -1.0;
  double status_shown_s_ = -1.0;
  double notice_until_s_ = 0.0;
  std::optional<double> ended_s_;  // when the source was first seen at its end
  std::size_t row_count_ = 0;
  bool rows_new_ = false;
  bool scene_seen_ = false;
  std::exception_ptr screenshot_fault_;
};

}  // namespace pellucida
