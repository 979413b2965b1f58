#pragma once
#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "TimedScreenshot.h"
#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core/Stage.h"
#include "pellucida/teach/Teach.h"
#include "pellucida/teaching/CellRunner.h"
#include "pellucida/teaching/Lesson.h"
#include "pellucida/teaching/QuasiStaticCurve.h"
#include "pellucida/teaching_vtk/PokedCellView.h"

class QLabel;
class QPushButton;
class QSplitter;
class QTabWidget;

namespace pellucida {

class LessonPanel;
class NodeForceTable;
class ParameterPanel;
class TeachReadouts;
class ViewWidget;

/// The lessons of a window, and which of them is first.
struct LessonChoice {
  std::vector<Lesson> lessons;
  int first = 0;
};
/// All shipped lessons, opened at the one named (empty: the first); one from a file comes after them. Throws as
/// `load_lesson`.
LessonChoice choose_lessons(const std::string& name);

/// The window in Teach mode: lessons on the left, the poked cell and its force curve in the middle, parameters and the
/// forces on a node on the right. The cell is stepped on a thread of its own; one timer shows what is newest.
class TeachWindow : public QMainWindow {
 public:
  TeachWindow(LessonChoice lessons, TeachOptions options);
  ~TeachWindow() override;

  const TimedScreenshot& screenshot() const noexcept { return *screenshot_; }
  CellRunner& runner() noexcept { return runner_; }
  PokedCellView& cell_view() noexcept { return cell_view_; }
  ViewWidget& cell_widget() noexcept { return *cell_widget_; }
  LessonPanel& lessons() noexcept { return *lesson_panel_; }
  ParameterPanel& parameters() noexcept { return *parameter_panel_; }

 private:
  void build(LessonChoice& lessons);
  QWidget* build_top_bar();
  QWidget* build_cell();
  QWidget* build_chart();
  QWidget* build_side();
  void add_keys();

  void tick();
  void show(const CellSnapshotPtr& snapshot);
  void show_curve(const CellSnapshot& snapshot);
  void show_slowly(const CellSnapshot& snapshot);
  void begin(const Lesson& lesson);
  void change(const TeachingParameters& parameters);
  void restart();
  void move_hand(double along_um, double across_um);
  void pick(int x_px, int y_px);
  void apply_look();

  TeachOptions options_;
  CellRunner runner_;
  SteadyClock clock_;
  SharedLatest<TeachingParameters> curve_orders_;
  SharedLatest<QuasiStaticCurvePtr> curves_;
  QuasiStaticStep curve_step_;
  Stage<QuasiStaticStep, SharedLatest<TeachingParameters>> curve_stage_;

  PokedCellView cell_view_;
  ForceChart chart_{ForceChartKind::kForceIndentation};
  ViewWidget* cell_widget_ = nullptr;
  ViewWidget* chart_widget_ = nullptr;
  TeachReadouts* readouts_ = nullptr;
  LessonPanel* lesson_panel_ = nullptr;
  ParameterPanel* parameter_panel_ = nullptr;
  NodeForceTable* force_table_ = nullptr;
  QTabWidget* side_ = nullptr;
  QWidget* banner_ = nullptr;
  QLabel* banner_text_ = nullptr;

  double hand_along_um_ = 0.0;
  double hand_across_um_ = 0.0;
  double hand_moved_s_ = 0.0;
  bool explains_tip_ = false;  // once its mesh is known
  std::uint64_t shown_sequence_ = 0;
  QuasiStaticCurvePtr shown_curve_;
  std::uint64_t shown_run_ = 0;
  double slow_shown_s_ = -1.0;
  long row_index_ = 0;
  int unseen_ticks_ = 3;
  QTimer timer_;
  std::unique_ptr<TimedScreenshot> screenshot_;
};

}  // namespace pellucida
