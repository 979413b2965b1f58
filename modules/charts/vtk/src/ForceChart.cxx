#include "pellucida/charts_vtk/ForceChart.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkRenderer.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <tuple>

#include "ChartAxes.h"
#include "pellucida/charts/Curve.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

// A time axis is never shorter than this.
constexpr double kLeastTime_s = 5.0;
constexpr double kLeastPull_uN = 0.1;

enum Column { kX, kForce, kLower, kUpper, kPictureLower, kPictureUpper, kTrue, kColumnCount };
constexpr std::array<const char*, kColumnCount> kColumnNames{
    "x", "force_uN", "lower_uN", "upper_uN", "picture_lower_uN", "picture_upper_uN", "true_uN"};
// The whole interval behind, what the picture leaves open in front.
constexpr double kWholeOpacity = 0.14, kPictureOpacity = 0.26;

vtkNew<vtkTable> make_table() {
  vtkNew<vtkTable> table;
  for (const char* name : kColumnNames) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  return table;
}

// The points from `first` on. At a gap two rows more: the curve has no number there, the band no width.
void fill_table(vtkTable* table, const std::vector<TracePoint>& points, std::size_t first, bool over_time) {
  table->SetNumberOfRows(0);
  const auto add = [&](const TracePoint& p, bool is_edge) {
    const double x = over_time ? p.time_s : p.indentation_um;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto edge = [&](double end_uN) { return is_edge ? p.force_uN : end_uN; };
    const double values[kColumnCount] = {x,
                                         is_edge ? nan : p.force_uN,
                                         edge(p.lower_uN),
                                         edge(p.upper_uN),
                                         edge(p.picture_lower_uN),
                                         edge(p.picture_upper_uN),
                                         is_edge ? nan : p.true_uN};
    for (int c = 0; c < kColumnCount; ++c) {
      vtkDoubleArray::SafeDownCast(table->GetColumn(c))->InsertNextValue(values[c]);
    }
  };
  for (std::size_t i = first; i < points.size(); ++i) {
    if (i > first && points[i].after_gap) {
      add(points[i - 1], true);
      add(points[i], true);
    }
    add(points[i], false);
  }
  for (int c = 0; c < kColumnCount; ++c) table->GetColumn(c)->Modified();
  table->Modified();
}

// Both bands over the indentation, along the way in alone: over the same depths, those of a hold and of the way back
// would lie on it as one block. There the bar at the newest point tells the interval.
void fill_bands(vtkTable* table, const std::vector<TracePoint>& points) {
  std::vector<double> depths_um;
  for (const TracePoint& p : points) depths_um.push_back(p.indentation_um);
  std::vector<TracePoint> bands;
  std::size_t next = 0;
  for (const std::size_t i : way_in(depths_um)) {
    bands.push_back(points[i]);
    // Also a gap among those left out.
    for (; next < i; ++next) bands.back().after_gap = bands.back().after_gap || points[next + 1].after_gap;
  }
  fill_table(table, bands, 0, false);
}

}  // namespace

struct ForceChart::Plots {
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkChartXY> chart;
  vtkNew<vtkTable> before_table = make_table();
  vtkNew<vtkTable> table = make_table();
  vtkNew<vtkTable> band_table = make_table();
  vtkNew<vtkTable> last_table = make_table();
  vtkPlotLine* before = nullptr;
  vtkPlotArea* band = nullptr;
  vtkPlotArea* picture_band = nullptr;
  vtkPlotLine* curve = nullptr;
  vtkPlotLine* truth = nullptr;
  vtkPlotPoints* last = nullptr;
};

ForceChart::ForceChart(ForceChartKind kind) : kind_(kind), plots_(std::make_unique<Plots>()) {
  Plots& p = *plots_;
  main_->SetUseFXAA(false);
  main_->SetBackground(current_theme().panel.data());
  p.actor->GetScene()->AddItem(p.chart);
  p.actor->GetScene()->SetRenderer(main_);
  main_->AddActor(p.actor);

  // From the back to the front: the touch before, the intervals, the curve, its newest point.
  p.before = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.band = vtkPlotArea::SafeDownCast(p.chart->AddPlot(vtkChart::AREA));
  p.picture_band = vtkPlotArea::SafeDownCast(p.chart->AddPlot(vtkChart::AREA));
  p.curve = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.truth = vtkPlotLine::SafeDownCast(p.chart->AddPlot(vtkChart::LINE));
  p.last = vtkPlotPoints::SafeDownCast(p.chart->AddPlot(vtkChart::POINTS));
  p.before->SetInputData(p.before_table, kX, kForce);
  for (const auto& [band, lower, upper] :
       {std::tuple{p.band, kLower, kUpper}, std::tuple{p.picture_band, kPictureLower, kPictureUpper}}) {
    band->SetInputData(kind == ForceChartKind::kForceTime ? p.table : p.band_table);
    band->SetInputArray(0, kColumnNames[kX]);
    band->SetInputArray(1, kColumnNames[lower]);
    band->SetInputArray(2, kColumnNames[upper]);
  }
  p.curve->SetInputData(p.table, kX, kForce);
  p.truth->SetInputData(p.table, kX, kTrue);
  p.last->SetInputData(p.last_table, kX, kForce);
  p.last->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  for (vtkPlot* plot : std::initializer_list<vtkPlot*>{p.before, p.band, p.picture_band, p.curve, p.truth, p.last}) {
    plot->SelectableOff();
    plot->SetVisible(false);
  }
  p.chart->SetShowLegend(false);
  p.chart->SetInteractive(false);
  p.chart->SetHiddenAxisBorder(12);
}

ForceChart::~ForceChart() = default;

void ForceChart::append(const Measurement& m, double true_force_uN) {
  const bool was_in_touch = history_.in_touch();
  history_.append(m, true_force_uN);
  // Between two touches the curve over the indentation stays as it is.
  if (kind_ == ForceChartKind::kForceTime || was_in_touch || history_.in_touch()) changed_ = true;
}

void ForceChart::show_truth(bool shown) {
  changed_ = changed_ || shown != truth_shown_;
  truth_shown_ = shown;
}

void ForceChart::clear() {
  history_.clear();
  changed_ = true;
}

const std::vector<TracePoint>& ForceChart::points() const {
  return kind_ == ForceChartKind::kForceTime ? history_.over_time() : history_.current_touch();
}

std::optional<TracePoint> ForceChart::newest() const {
  return points().empty() ? std::nullopt : std::optional(points().back());
}

void ForceChart::set_time_window_s(double window_s) {
  time_window_s_ = window_s;
  changed_ = true;
}

void ForceChart::set_reference(std::string name, const std::vector<double>& depth_um,
                               const std::vector<double>& force_uN) {
  reference_name_ = std::move(name);
  reference_.clear();
  for (std::size_t k = 0; k < std::min(depth_um.size(), force_uN.size()); ++k) {
    reference_.push_back({.indentation_um = depth_um[k],
                          .force_uN = force_uN[k],
                          .lower_uN = force_uN[k],
                          .upper_uN = force_uN[k],
                          .picture_lower_uN = force_uN[k],
                          .picture_upper_uN = force_uN[k]});
  }
  changed_ = true;
}

void ForceChart::follow_theme() {
  theme_ = &current_theme();
  styled_ratio_ = 0.0;
  main_->SetBackground(theme_->panel.data());
}

const std::vector<TracePoint>& ForceChart::behind() const {
  return reference_name_.empty() ? history_.previous_touch() : reference_;
}

void ForceChart::style_axes(double ratio) {
  if (ratio == styled_ratio_) return;
  styled_ratio_ = ratio;
  Plots& p = *plots_;
  const std::string x_title = kind_ == ForceChartKind::kForceTime ? say("Time (s)") : say("Indentation (µm)");
  for (const auto& [side, title] : {std::pair<int, std::string>{vtkAxis::BOTTOM, x_title},
                                    std::pair<int, std::string>{vtkAxis::LEFT, say("Force (µN)")}}) {
    style_axis(p.chart->GetAxis(side), title, *theme_, ratio);
  }
  p.before->SetWidth(static_cast<float>(1.5 * ratio));
  set_color(p.before->GetPen(), theme_->curve_before);
  p.curve->SetWidth(static_cast<float>(2.0 * ratio));
  set_color(p.curve->GetPen(), theme_->curve);
  for (const auto& [band, opacity] : {std::pair{p.band, kWholeOpacity}, std::pair{p.picture_band, kPictureOpacity}}) {
    band->GetBrush()->SetColorF(theme_->curve.red, theme_->curve.green, theme_->curve.blue, opacity);
    set_color(band->GetPen(), theme_->curve, 0.0);
  }
  p.truth->SetWidth(static_cast<float>(1.5 * ratio));
  set_color(p.truth->GetPen(), theme_->good);
  p.last->SetMarkerSize(static_cast<float>(9.0 * ratio));
  set_color(p.last->GetPen(), theme_->text);
}

void ForceChart::fill() {
  Plots& p = *plots_;
  const bool over_time = kind_ == ForceChartKind::kForceTime;
  const std::vector<TracePoint>& points = this->points();

  // Rows before the window's beginning are left out, but for one that lets the curve run in from the left.
  std::size_t first = 0;
  if (over_time && time_window_s_ > 0.0 && !points.empty()) {
    const double begin_s = points.back().time_s - time_window_s_;
    const auto inside = std::find_if(points.begin(), points.end(), [&](const auto& q) { return q.time_s >= begin_s; });
    first = inside == points.begin() ? 0 : static_cast<std::size_t>(inside - points.begin()) - 1;
  }
  fill_table(p.table, points, first, over_time);
  if (!over_time) fill_bands(p.band_table, points);
  fill_table(p.last_table, points, points.empty() ? 0 : points.size() - 1, over_time);
  fill_table(p.before_table, behind(), 0, over_time);
  const bool drawable = points.size() - first > 1;
  p.curve->SetVisible(drawable);
  p.truth->SetVisible(drawable && truth_shown_);
  // A needle that rests has a curve of no width, and no band.
  const bool has_band = over_time ? drawable : p.band_table->GetNumberOfRows() > 1;
  p.band->SetVisible(has_band);
  p.picture_band->SetVisible(has_band);
  p.last->SetVisible(over_time ? !points.empty() : history_.in_touch());
  p.before->SetVisible(!over_time && behind().size() > 1);
  set_ranges();
  p.chart->RecalculateBounds();
}

void ForceChart::set_ranges() {
  Plots& p = *plots_;
  const bool over_time = kind_ == ForceChartKind::kForceTime;
  double greatest_uN = 0.0;
  double greatest_um = 0.0;
  double least_uN = 0.0;
  const auto measure = [&](const std::vector<TracePoint>& points) {
    for (const TracePoint& point : points) {
      greatest_uN = std::max(greatest_uN, point.upper_uN);
      least_uN = std::min(least_uN, point.force_uN);
      if (truth_shown_ && std::isfinite(point.true_uN)) greatest_uN = std::max(greatest_uN, point.true_uN);
      if (std::isfinite(point.indentation_um)) greatest_um = std::max(greatest_um, point.indentation_um);
    }
  };
  measure(points());
  if (!over_time) measure(behind());
  const double ratio = std::max(hud_ratio(), 1e-3);
  const int* size = main_->GetSize();
  // Beside a reference a pull counts too; a measured force below 0 is noise.
  const double bottom_uN = reference_name_.empty() || least_uN > -kLeastPull_uN ? 0.0 : -axis_end(-least_uN, 1.0);
  set_ticks(p.chart->GetAxis(vtkAxis::LEFT), bottom_uN, axis_end(1.04 * greatest_uN, 1.0), size[1] / ratio,
            kTickRoomUp_px);

  // Time: all of it, or the last part once that is full.
  double begin = 0.0;
  double end = axis_end(1.02 * greatest_um, 10.0);
  if (over_time) {
    const auto& points = history_.over_time();
    // A run whose force began early is shown from its start.
    const double first_s = points.empty() || points.front().time_s < kLeastTime_s ? 0.0 : points.front().time_s;
    const double last_s = points.empty() ? 0.0 : points.back().time_s;
    begin = time_window_s_ > 0.0 ? std::max(first_s, last_s - time_window_s_) : first_s;
    end = std::max(last_s + 0.03 * (last_s - begin), begin + kLeastTime_s);
  }
  set_ticks(p.chart->GetAxis(vtkAxis::BOTTOM), begin, end, size[0] / ratio, kTickRoomAcross_px);
}

void ForceChart::prepare(double width_px, double height_px) {
  if (width_px < 1.0 || height_px < 1.0) return;
  style_axes(hud_ratio());
  if (changed_) {
    fill();
  } else {
    set_ranges();
  }
  changed_ = false;
}

void ForceChart::draw_hud(HudCanvas& hud, double width_px, double height_px) {
  if (!reference_name_.empty()) draw_reference_name(hud);
  if (truth_shown_ && !points().empty()) draw_truth_name(hud, width_px);
  if (!points().empty()) {
    if (kind_ == ForceChartKind::kForceTime) {
      draw_marks(hud);
    } else if (history_.in_touch()) {
      draw_interval(hud, points().back());
    }
    return;
  }
  if (!reference_name_.empty()) return;
  hud.text(0.5 * width_px, 0.55 * height_px, say("No force measured yet"),
           {.size_pt = font_size::kNormal, .color = theme_->text_dim, .align = HudAlign::kCentre});
}

// A stroke of each curve with its name, in the upper left corner.
void ForceChart::draw_reference_name(HudCanvas& hud) const {
  constexpr double kStroke_px = 26.0, kRow_px = 20.0;
  const double x = plots_->chart->GetAxis(vtkAxis::BOTTOM)->GetPoint1()[0] / hud_ratio() + 14.0;
  double y = plots_->chart->GetAxis(vtkAxis::LEFT)->GetPoint2()[1] / hud_ratio() - 12.0;
  for (const auto& [name, color] :
       {std::pair{say("now"), theme_->curve}, std::pair{reference_name_, theme_->curve_before}}) {
    hud.line(x, y, x + kStroke_px, y, 2.5, color);
    hud.text(x + kStroke_px + 8.0, y, name, {.color = theme_->text_dim});
    y -= kRow_px;
  }
}

// At the lower right, where a curve that rises and falls leaves room.
void ForceChart::draw_truth_name(HudCanvas& hud, double width_px) const {
  constexpr double kStroke_px = 22.0, kMargin_px = 18.0;
  const double y = plots_->chart->GetAxis(vtkAxis::LEFT)->GetPoint1()[1] / hud_ratio() + 14.0;
  const double x = width_px - kMargin_px - hud.text_width_px(say("true force"));
  hud.text(x, y, say("true force"), {.color = theme_->text_dim});
  hud.line(x - 8.0 - kStroke_px, y, x - 8.0, y, 2.0, theme_->good);
}

// The intervals of one point, the whole and what the picture leaves open, as upright bars.
void ForceChart::draw_interval(HudCanvas& hud, const TracePoint& point) const {
  vtkAxis* bottom = plots_->chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = plots_->chart->GetAxis(vtkAxis::LEFT);
  const auto place = [&](vtkAxis* axis, int part, double value) {
    const double share = (value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
    return (axis->GetPoint1()[part] + share * (axis->GetPoint2()[part] - axis->GetPoint1()[part])) / hud_ratio();
  };
  if (!std::isfinite(point.indentation_um)) return;
  const double x = place(bottom, 0, point.indentation_um);
  const auto bar = [&](double lower_uN, double upper_uN, double width_px, double end_px) {
    if (!(upper_uN > lower_uN)) return;
    const double low = place(left, 1, lower_uN), high = place(left, 1, upper_uN);
    hud.line(x, low, x, high, width_px, theme_->text_dim);
    for (const double y : {low, high}) hud.line(x - end_px, y, x + end_px, y, 1.5, theme_->text_dim);
  };
  bar(point.lower_uN, point.upper_uN, 1.5, 5.0);
  bar(point.picture_lower_uN, point.picture_upper_uN, 3.0, 0.5);
}

// An upright line at each moment, named at its upper end where there is room.
void ForceChart::draw_marks(HudCanvas& hud) const {
  vtkAxis* bottom = plots_->chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = plots_->chart->GetAxis(vtkAxis::LEFT);
  const double begin_s = bottom->GetMinimum();
  const double end_s = bottom->GetMaximum();
  const double x0 = bottom->GetPoint1()[0] / hud_ratio();
  const double x1 = bottom->GetPoint2()[0] / hud_ratio();
  const double y0 = left->GetPoint1()[1] / hud_ratio();
  const double y1 = left->GetPoint2()[1] / hud_ratio();
  double free_from = x0;
  for (const TraceMark& mark : history_.marks()) {
    if (mark.time_s < begin_s || mark.time_s > end_s) continue;
    const Color color = state_color(mark.state);
    const double x = x0 + (x1 - x0) * (mark.time_s - begin_s) / (end_s - begin_s);
    hud.line(x, y0, x, y1, 1.25, color, 0.8);
    const std::string name = readout::state(mark.state);
    const double width = hud.text_width_px(name) + 10.0;
    if (x < free_from || x + width > x1) continue;
    hud.text(x + 6.0, y1 - 9.0, name, {.color = color});
    free_from = x + width;
  }
}

}  // namespace pellucida
