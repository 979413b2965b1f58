#include "presenters/ChartForPrint.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "pellucida/core/RoundNumbers.h"
#include "pellucida/core/Words.h"
#include "pellucida/visualization/Readout.h"

namespace pellucida {
namespace {

constexpr Color kPrintCurve = Color::from_hex(0x1F77B4);
constexpr Color kPrintOther = Color::from_hex(0xC25E00);
constexpr Color kPrintFaint = Color::from_hex(0x9AA5B1);
// More would cover the chart.
constexpr std::size_t kMostNamedMarks = 5;
constexpr Color kPrintReference = Color::from_hex(0x2B7A3D);
constexpr Color kPrintMark = Color::from_hex(0x5A6470);

struct PrintRange {
  double low = 0.0;
  double high = 0.0;
  void include(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  // Ends on round numbers; never empty.
  std::pair<double, double> ends() const {
    const double top = high > low ? high : low + 1.0;
    const auto ticks = round_ticks(low, top, TickEnds::kOutside);
    return {ticks.front(), ticks.back()};
  }
};

// How a curve is drawn: its line, its band, or both. An empty name: not drawn.
struct PartNames {
  std::string line;
  std::string band;
};

// A series without gaps for each unbroken part of the curve; only the first is named in the legend.
void add_parts(const Curve& curve, const PartNames& names, const Color& color, double opacity, ChartPanel& panel) {
  ChartSeries line, band;
  std::string line_name = names.line, band_name = names.band;
  const bool with_band = !names.band.empty();
  const auto flush = [&] {
    if (line.x.empty()) return;
    if (with_band && !is_ascending(curve)) {
      const Curve around = band_of_way_in(curve);
      band.x = around.x;
      band.y = around.lower;
      band.y_upper = around.upper;
    }
    if (with_band && band.y != band.y_upper) {
      band.name = std::exchange(band_name, {});
      band.style = ChartStyle::kBand;
      band.color = color;
      band.opacity = opacity;
      panel.series.push_back(band);
    }
    line.name = std::exchange(line_name, {});
    line.color = color;
    if (!names.line.empty()) panel.series.push_back(line);
    line = band = ChartSeries{};
  };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::isnan(curve.y[i])) {
      flush();
      continue;
    }
    line.x.push_back(curve.x[i]);
    line.y.push_back(curve.y[i]);
    band.x.push_back(curve.x[i]);
    band.y.push_back(curve.lower[i]);
    band.y_upper.push_back(curve.upper[i]);
  }
  flush();
}

}  // namespace

ChartPanel chart_for_print(const CurveChartData& data, const std::string& title) {
  ChartPanel panel;
  panel.title = title;
  panel.x_title = data.x_title;
  panel.y_title = data.y_title;
  PrintRange x, y;
  std::vector<const Curve*> curves{&data.faint, &data.curve, &data.other};
  for (const NamedCurve& named : data.named) curves.push_back(&named.curve);
  for (const Curve* curve : curves) {
    x.include(curve->x);
    y.include(curve->lower);
    y.include(curve->upper);
  }
  std::tie(panel.y_begin, panel.y_end) = y.ends();
  std::tie(panel.x_begin, panel.x_end) = x.ends();
  if (data.x_end > data.x_begin) std::tie(panel.x_begin, panel.x_end) = std::pair(data.x_begin, data.x_end);
  const auto add = [&](const Curve& curve, const PartNames& names, const Color& color, double opacity) {
    add_parts(thinned(curve, CurveChart::kMostPoints), names, color, opacity, panel);
  };
  const std::string quantity = data.y_title.substr(0, data.y_title.find(" ("));
  add(data.faint, {say("other touches"), ""}, kPrintFaint, 0.0);
  add(data.other, {data.other_name, ""}, kPrintOther, 0.25);
  const std::string name = data.other_name.empty() && data.named.empty() ? quantity : data.curve_name;
  if (data.inner.empty()) {
    add(data.curve, {name, data.band_name.empty() ? say("95 % interval") : data.band_name}, kPrintCurve, 0.25);
  } else {
    add(data.curve, {"", say("95 % interval, the whole")}, kPrintCurve, 0.15);
    add(data.inner, {name, say("95 % interval, picture")}, kPrintCurve, 0.3);
  }
  for (const NamedCurve& named : data.named) {
    const std::size_t before = panel.series.size();
    const bool back = named.role == CurveRole::kBack, faint = named.role == CurveRole::kFaintReference;
    add(named.curve, {named.name, ""}, back ? kPrintCurve : faint ? kPrintMark : kPrintReference, 0.0);
    for (std::size_t k = before; k < panel.series.size(); ++k) panel.series[k].style = ChartStyle::kDashedLine;
  }
  for (const CurveMark& mark : data.marks) {
    ChartSeries line;
    if (data.marks.size() <= kMostNamedMarks) line.name = mark.name + say(" at ") + readout::time(mark.x);
    line.style = ChartStyle::kDashedLine;
    line.x = {mark.x, mark.x};
    line.y = {panel.y_begin, panel.y_end};
    line.color = kPrintMark;
    line.width_px = 1.2;
    panel.series.push_back(line);
  }
  panel.legend_right = true;
  return panel;
}

}  // namespace pellucida
