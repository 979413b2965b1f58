#pragma once
#include <cstdint>
#include <functional>

#include "TeachPage.h"
#include "pellucida/charts_vtk/ForceChart.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core/Stage.h"
#include "pellucida/teaching/CellRunner.h"
#include "pellucida/teaching/QuasiStaticCurve.h"
#include "pellucida/teaching_vtk/PokedCellView.h"

class QLabel;
class QTabWidget;

namespace pellucida {

class FigureBar;
class NodeForceTable;
class ParameterPanel;
class ViewWidget;

/// A cell to poke: the cell and its force curve, parameters and the forces on a node. It is stepped on a thread of its
/// own.
class CellPage : public TeachPage {
 public:
  explicit CellPage(const TeachingParameters& first);
  ~CellPage() override;

  CellRunner& runner() noexcept { return runner_; }
  PokedCellView& view() noexcept { return cell_view_; }
  ViewWidget& view_widget() noexcept { return *cell_widget_; }
  ParameterPanel& parameters() noexcept { return *parameter_panel_; }

  /// The needle out of the cell.
  void withdraw();

  QWidget* make_figures() override;
  QWidget* make_stage() override;
  QWidget* make_side() override;
  void begin(const Lesson& lesson) override;
  void set_shown(bool shown) override;
  void tick() override;
  void show_newest() override;
  void restart() override;
  void nudge(double right_um, double up_um) override;
  void reset_view() override { cell_view_.reset_camera(); }
  void set_type_scale(double scale) override;

 private:
  QWidget* make_cell();
  QWidget* make_chart();
  void show(const CellSnapshotPtr& snapshot);
  void show_curve(const CellSnapshot& snapshot);
  void show_slowly(const CellSnapshot& snapshot);
  void change(const TeachingParameters& parameters);
  void move_hand(double along_um, double across_um);
  void pick(int x_px, int y_px);

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
  FigureBar* figures_ = nullptr;
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
};

}  // namespace pellucida
