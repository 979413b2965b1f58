#include "pellucida/charts_vtk/CurveChart.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotLine.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "ChartAxes.h"
#include "pellucida/core/RoundNumbers.h"

namespace pellucida {
namespace {

// Of one band alone; of two.
constexpr double kBandOpacity = 0.22, kOuterOpacity = 0.14, kInnerOpacity = 0.26;

enum CurveColumn { kCurveX, kCurveY, kCurveLower, kCurveUpper, kCurveColumnCount };

vtkNew<vtkTable> make_curve_table() {
  vtkNew<vtkTable> table;
  for (const char* name : {"x", "y", "lower", "upper"}) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  return table;
}

// The band can't have a gap: it narrows to nothing there, on both sides.
void fill_curve_table(vtkTable* table, const Curve& curve) {
  std::array<vtkDoubleArray*, kCurveColumnCount> columns{};
  for (int c = 0; c < kCurveColumnCount; ++c) {
    columns[static_cast<std::size_t>(c)] = vtkDoubleArray::SafeDownCast(table->GetColumn(c));
    columns[static_cast<std::size_t>(c)]->Reset();
  }
  const auto add = [&](double x, double y, double lower, double upper) {
    columns[kCurveX]->InsertNextValue(x);
    columns[kCurveY]->InsertNextValue(y);
    columns[kCurveLower]->InsertNextValue(lower);
    columns[kCurveUpper]->InsertNextValue(upper);
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isnan(curve.y[i])) {
      add(curve.x[i], curve.y[i], curve.lower[i], curve.upper[i]);
      continue;
    }
    if (i == 0 || i + 1 == curve.size()) continue;
    add(curve.x[i - 1], curve.y[i], curve.y[i - 1], curve.y[i - 1]);
    add(curve.x[i + 1], curve.y[i], curve.y[i + 1], curve.y[i + 1]);
  }
  for (vtkDoubleArray* column : columns) column->Modified();
  table->Modified();
}

vtkPlotArea* add_band(vtkChartXY* chart, vtkTable* table) {
  vtkPlotArea* band = vtkPlotArea::SafeDownCast(chart->AddPlot(vtkChart::AREA));
  band->SetInputData(table);
  band->SetInputArray(0, "x");
  band->SetInputArray(1, "lower");
  band->SetInputArray(2, "upper");
  return band;
}

void style_line(vtkPlotLine* line, const Color& color, double ratio) {
  line->SetWidth(static_cast<float>(2.0 * ratio));
  set_color(line->GetPen(), color);
}

Color color_of(CurveRole role) {
  if (role == CurveRole::kBack) return current_theme().curve;
  return role == CurveRole::kReference ? current_theme().good : current_theme().curve_before;
}

void style_named(vtkPlotLine* line, CurveRole role, double ratio) {
  style_line(line, color_of(role), ratio);
  line->GetPen()->SetLineType(role == CurveRole::kFaintReference ? vtkPen::DOT_LINE : vtkPen::DASH_LINE);
}

void style_band(vtkPlotArea* band, const Color& color, double opacity) {
  band->GetBrush()->SetColorF(color.red, color.green, color.blue, opacity);
  set_color(band->GetPen(), color, 0.0);
}

struct Extent {
  double low = 0.0;
  double high = 0.0;
  void include(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
};

}  // namespace

struct CurveChart::Plots {
  CurveChartData data;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkChartXY> chart;
  vtkNew<vtkTable> faint_table = make_curve_table();
  vtkNew<vtkTable> table = make_curve_table();
  vtkNew<vtkTable> band_table = make_curve_table();
  vtkNew<vtkTable> other_table = make_curve_table();
  vtkNew<vtkTable> other_band_table = make_curve_table();
  vtkNew<vtkTable> inner_table = make_curve_table();
  vtkPlotLine* faint = nullptr;
  vtkPlotArea* other_band = nullptr;
  vtkPlotArea* band = nullptr;
  vtkPlotArea* inner = nullptr;
  vtkPlotLine* other = nullptr;
  vtkPlotLine* curve = nullptr;
  // As many as were ever shown.
  std::vector<vtkSmartPointer<vtkTable>> named_tables;
  std::vector<vtkPlotLine*> named;
};

CurveChart::CurveChart() : plots_(std::make_unique<Plots>()) {
  Plots& p = *plots_;
  main_->SetUseFXAA(false);
  follow_theme();
  p.actor->GetScene()->AddItem(p.chart);
  p.actor->GetScene()->SetRenderer(main_);
  main_->AddActor(p.actor);
  p.faint = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.other_band = add_band(p.chart, p.other_band_table);
  p.band = add_band(p.chart, p.band_table);
  p.inner = add_band(p.chart, p.inner_table);
  p.other = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.curve = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.faint->SetInputData(p.faint_table, kCurveX, kCurveY);
  p.other->SetInputData(p.other_table, kCurveX, kCurveY);
  p.curve->SetInputData(p.table, kCurveX, kCurveY);
  for (vtkPlot* plot : std::initializer_list<vtkPlot*>{p.faint, p.other_band, p.band, p.inner, p.other, p.curve}) {
    plot->SelectableOff();
    plot->SetVisible(false);
  }
  p.chart->SetShowLegend(false);
  p.chart->SetInteractive(false);
  p.chart->SetHiddenAxisBorder(12);
}

CurveChart::~CurveChart() = default;

void CurveChart::follow_theme() {
  main_->SetBackground(current_theme().panel.data());
  styled_ratio_ = 0.0;
}

void CurveChart::set_data(CurveChartData data) {
  plots_->data = std::move(data);
  changed_ = true;
}

const CurveChartData& CurveChart::data() const noexcept {
  return plots_->data;
}

void CurveChart::set_cursor(double x, double y, bool line) {
  cursor_x_ = x;
  cursor_y_ = y;
  cursor_line_ = line;
}

void CurveChart::fill() {
  Plots& p = *plots_;
  fill_curve_table(p.faint_table, thinned(p.data.faint, kMostPoints));
  const auto band_of = [](const Curve& curve) {
    return thinned(is_ascending(curve) ? curve : band_of_way_in(curve), kMostPoints);
  };
  fill_curve_table(p.table, thinned(p.data.curve, kMostPoints));
  fill_curve_table(p.other_table, thinned(p.data.other, kMostPoints));
  fill_curve_table(p.band_table, band_of(p.data.curve));
  fill_curve_table(p.other_band_table, band_of(p.data.other));
  fill_curve_table(p.inner_table, band_of(p.data.inner));
  const auto show = [](const Curve& curve, std::initializer_list<vtkPlot*> plots) {
    for (vtkPlot* plot : plots) plot->SetVisible(curve.size() > 1);
  };
  show(p.data.faint, {p.faint});
  show(p.data.curve, {p.curve, p.band});
  show(p.data.other, {p.other, p.other_band});
  show(p.data.inner, {p.inner});
  while (p.named.size() < p.data.named.size()) {
    p.named_tables.emplace_back(make_curve_table().Get());
    p.named.push_back(vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE)));
    p.named.back()->SetInputData(p.named_tables.back(), kCurveX, kCurveY);
    p.named.back()->SelectableOff();
  }
  for (std::size_t k = 0; k < p.named.size(); ++k) {
    const bool used = k < p.data.named.size();
    fill_curve_table(p.named_tables[k], used ? thinned(p.data.named[k].curve, kMostPoints) : Curve{});
    p.named[k]->SetVisible(used && p.data.named[k].curve.size() > 1);
  }
}

std::vector<const Curve*> CurveChart::curves() const {
  const CurveChartData& data = plots_->data;
  std::vector<const Curve*> curves{&data.faint, &data.curve, &data.other};
  for (const NamedCurve& named : data.named) curves.push_back(&named.curve);
  return curves;
}

void CurveChart::set_ranges(double width_px, double height_px) {
  Plots& p = *plots_;
  const CurveChartData& data = p.data;
  Extent y;
  for (const Curve* curve : curves()) {
    y.include(curve->lower);
    y.include(curve->upper);
  }
  const double bottom = y.low < 0.0 ? -axis_end(-1.04 * y.low, 1e-9) : 0.0;
  const double top = y.high > 0.0 ? axis_end(1.04 * y.high, 1e-9) : bottom < 0.0 ? 0.0 : 1.0;
  set_ticks(p.chart->GetAxis(vtkAxis::LEFT), bottom, top, height_px, kTickRoomUp_px);
  double begin = data.x_begin, end = data.x_end;
  if (!(end > begin)) {
    Extent x;
    for (const Curve* curve : curves()) x.include(curve->x);
    begin = 0.0;
    end = axis_end(1.02 * x.high, 10.0);
  }
  set_ticks(p.chart->GetAxis(vtkAxis::BOTTOM), begin, end, width_px, kTickRoomAcross_px);
}

void CurveChart::prepare(double width_px, double height_px) {
  if (width_px < 1.0 || height_px < 1.0) return;
  Plots& p = *plots_;
  const double ratio = std::max(hud_ratio(), 1e-3);
  if (changed_ || ratio != styled_ratio_) {
    style_axis(p.chart->GetAxis(vtkAxis::BOTTOM), p.data.x_title, current_theme(), ratio);
    style_axis(p.chart->GetAxis(vtkAxis::LEFT), p.data.y_title, current_theme(), ratio);
    p.faint->SetWidth(static_cast<float>(1.5 * ratio));
    set_color(p.faint->GetPen(), current_theme().curve_before);
    style_line(p.curve, current_theme().curve, ratio);
    style_line(p.other, current_theme().curve_other, ratio);
    style_band(p.band, current_theme().curve, p.data.inner.empty() ? kBandOpacity : kOuterOpacity);
    style_band(p.inner, current_theme().curve, kInnerOpacity);
    style_band(p.other_band, current_theme().curve_other, kBandOpacity);
    styled_ratio_ = ratio;
  }
  if (changed_) {
    fill();
    for (std::size_t k = 0; k < p.data.named.size(); ++k) style_named(p.named[k], p.data.named[k].role, ratio);
  }
  set_ranges(width_px / ratio, height_px / ratio);
  if (changed_) p.chart->RecalculateBounds();
  changed_ = false;
}

std::optional<double> CurveChart::x_at(double x_px) const {
  vtkAxis* bottom = plots_->chart->GetAxis(vtkAxis::BOTTOM);
  const double x0 = bottom->GetPoint1()[0] / hud_ratio();
  const double x1 = bottom->GetPoint2()[0] / hud_ratio();
  if (!(x1 > x0)) return std::nullopt;
  const double share = std::clamp((x_px - x0) / (x1 - x0), 0.0, 1.0);
  return bottom->GetMinimum() + share * (bottom->GetMaximum() - bottom->GetMinimum());
}

void CurveChart::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  const CurveChartData& data = plots_->data;
  const auto all = curves();
  if (std::all_of(all.begin(), all.end(), [](const Curve* curve) { return curve->empty(); })) {
    hud.text(0.5 * width_px, 0.55 * height_px, data.empty_text,
             {.size_pt = font_size::kNormal, .color = current_theme().text_dim, .align = HudAlign::kCentre});
  } else {
    draw_marks(hud);
    draw_names(hud);
  }
  draw_cursor(hud);
}

void CurveChart::draw_marks(HudCanvas& hud) const {
  vtkAxis* bottom = plots_->chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = plots_->chart->GetAxis(vtkAxis::LEFT);
  const double x0 = bottom->GetPoint1()[0] / hud_ratio(), x1 = bottom->GetPoint2()[0] / hud_ratio();
  const double y0 = left->GetPoint1()[1] / hud_ratio(), y1 = left->GetPoint2()[1] / hud_ratio();
  double free_from = x0;
  for (const CurveMark& mark : plots_->data.marks) {
    if (mark.x < bottom->GetMinimum() || mark.x > bottom->GetMaximum()) continue;
    const double share = (mark.x - bottom->GetMinimum()) / (bottom->GetMaximum() - bottom->GetMinimum());
    const double x = x0 + (x1 - x0) * share;
    hud.line(x, y0, x, y1, 1.25, mark.color, 0.8);
    const double width = hud.text_width_px(mark.name) + 10.0;
    if (x < free_from || x + width > x1) continue;
    hud.text(x + 6.0, y1 - 9.0, mark.name, {.color = mark.color});
    free_from = x + width;
  }
}

// At the left, where curves that begin at zero leave room; below the marks' names.
void CurveChart::draw_names(HudCanvas& hud) const {
  const CurveChartData& data = plots_->data;
  if (data.other_name.empty() && data.named.empty()) return;
  vtkAxis* left = plots_->chart->GetAxis(vtkAxis::LEFT);
  // Marks have their names at the top.
  const double top = left->GetPoint2()[1] / hud_ratio() - (data.marks.empty() ? 9.0 : 26.0);
  double x = left->GetPoint2()[0] / hud_ratio() + 10.0, y = top, widest = 0.0;
  const double lowest = 0.5 * (left->GetPoint1()[1] + left->GetPoint2()[1]) / hud_ratio();
  const auto name = [&](const std::string& text, const Color& color, std::initializer_list<double> dashes) {
    if (text.empty()) return;
    // In the upper half alone: in columns where the chart is low.
    if (y < lowest && y < top) {
      x += widest + 42.0;
      y = top;
      widest = 0.0;
    }
    widest = std::max(widest, hud.text_width_px(text));
    for (const double dash : dashes)
      hud.line(x + dash, y, x + dash + 16.0 / static_cast<double>(2 * dashes.size() - 1), y, 3.0, color);
    hud.text(x + 22.0, y, text);
    y -= 17.0;
  };
  if (data.curve.size() > 1) name(data.curve_name, current_theme().curve, {0.0});
  if (data.other.size() > 1 || data.named.empty()) name(data.other_name, current_theme().curve_other, {0.0});
  for (const NamedCurve& named : data.named) {
    if (named.curve.size() < 2) continue;
    if (named.role == CurveRole::kFaintReference) {
      name(named.name, color_of(named.role), {0.0, 6.4, 12.8});
    } else {
      name(named.name, color_of(named.role), {0.0, 10.6});
    }
  }
}

void CurveChart::draw_cursor(HudCanvas& hud) const {
  vtkAxis* bottom = plots_->chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = plots_->chart->GetAxis(vtkAxis::LEFT);
  if (!(cursor_x_ >= bottom->GetMinimum() && cursor_x_ <= bottom->GetMaximum())) return;
  const auto at = [&](vtkAxis* axis, int k, double value) {
    const double share = (value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
    return (axis->GetPoint1()[k] + share * (axis->GetPoint2()[k] - axis->GetPoint1()[k])) / hud_ratio();
  };
  const double x = at(bottom, 0, cursor_x_);
  if (cursor_line_) {
    hud.line(x, at(left, 1, left->GetMinimum()), x, at(left, 1, left->GetMaximum()), 1.5, current_theme().text, 0.9);
  }
  if (std::isfinite(cursor_y_)) {
    hud.disc(x, at(left, 1, cursor_y_), 5.5, current_theme().panel);
    hud.disc(x, at(left, 1, cursor_y_), 4.0, current_theme().text);
  }
}

}  // namespace pellucida
