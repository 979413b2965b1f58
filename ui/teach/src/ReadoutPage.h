#pragma once
#include <QString>
#include <array>

#include "ReadoutSteps.h"
#include "TeachPage.h"
#include "pellucida/charts_vtk/CurveChart.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/SharedLatest.h"
#include "pellucida/core/Stage.h"
#include "pellucida/teaching_vtk/PokedCellView.h"
#include "presenters/ComparisonPresenter.h"

class QComboBox;
class QTabWidget;

namespace pellucida {

class FigureBar;
class NodeForceTable;
class ParameterSlider;
class Panel;
class ViewWidget;

/// A contour read in two ways side by side: the equilibrium, as Pellucida reads, and every node prescribed; shapes,
/// connectors and the force on every node on the same scales, and both forces over depth. Computed on threads of its
/// own.
class ReadoutPage : public TeachPage {
 public:
  ReadoutPage();
  ~ReadoutPage() override;

  /// What is shown; null before the first.
  const ReadoutPairPtr& shown() const noexcept { return pair_; }
  const CurveChartData& chart_data() const noexcept { return chart_.data(); }
  const PokedCellView& equilibrium_view() const noexcept { return views_[0]; }
  const PokedCellView& prescribed_view() const noexcept { return views_[1]; }
  ParameterSlider& slider(ReadoutSlider which) { return *sliders_[static_cast<std::size_t>(which)]; }

  QWidget* make_figures() override;
  QWidget* make_stage() override;
  QWidget* make_side() override;
  void begin(const Lesson& lesson) override;
  void set_shown(bool shown) override;
  void tick() override;
  void show_newest() override;
  void restart() override;
  void nudge(double right_um, double up_um) override;
  void reset_view() override;
  void set_type_scale(double scale) override;

 private:
  Panel* make_view(std::size_t which, const QString& title);
  void show_controls();
  void change(ReadoutSlider which, double value);
  void order();
  void pick(std::size_t which, int x_px, int y_px);
  void take();
  void show_pair();
  void show_curves(const ReadoutCurves& curves);

  ReadoutParameters first_;  // the lesson's
  ReadoutParameters parameters_;
  std::optional<int> node_;
  std::size_t explained_ = 1;  // the view whose node was picked

  SteadyClock clock_;
  SharedLatest<ReadoutOrder> orders_;
  SharedLatest<ReadoutPairPtr> pairs_;
  ReadoutStep step_;
  Stage<ReadoutStep, SharedLatest<ReadoutOrder>> stage_;
  SharedLatest<ReadoutParameters> curve_orders_;
  SharedLatest<ReadoutCurvesPtr> curves_;
  ReadoutCurveStep curve_step_;
  Stage<ReadoutCurveStep, SharedLatest<ReadoutParameters>> curve_stage_;
  ReadoutPairPtr pair_;
  ReadoutCurvesPtr shown_curves_;

  std::array<PokedCellView, 2> views_;  // equilibrium, prescribed
  CurveChart chart_;
  std::array<ViewWidget*, 3> widgets_{};  // of the two views and the chart
  FigureBar* figures_ = nullptr;
  QTabWidget* side_ = nullptr;
  QComboBox* contour_ = nullptr;
  QComboBox* laying_ = nullptr;
  NodeForceTable* force_table_ = nullptr;
  std::array<ParameterSlider*, kReadoutSliderCount> sliders_{};
};

}  // namespace pellucida
