#include "PassportCharts.h"

#include <algorithm>
#include <cmath>

#include "CellSpans.h"
#include "SvgChart.h"
#include "pellucida/core/Html.h"

namespace pellucida {
namespace {

constexpr double kBreak = ContactPassport::kNone;
/// What is shown before the first touch and after the last release.
constexpr double kMargin_s = 0.5;
/// Without a number for longer than this, a curve has a gap, as in the window.
constexpr double kBridged_s = 0.5;
constexpr std::size_t kMostNamed = 12;

// The rows of all contacts with a margin on both sides, within the cell's.
RowRange shown_rows(const PassportInput& input, const CellPassport& cell) {
  RowRange range{cell.contact_list.front().rows.begin, cell.contact_list.back().rows.end};
  const double from_s = input.rows[range.begin].time_s - kMargin_s;
  const double to_s = input.rows[range.end - 1].time_s + kMargin_s;
  while (range.begin > cell.rows.begin && input.rows[range.begin - 1].time_s >= from_s) --range.begin;
  while (range.end < cell.rows.end && input.rows[range.end].time_s <= to_s) ++range.end;
  return range;
}

// A curve of what `value` says of a row, NaN for nothing.
template <class Value>
std::vector<ChartPoint> over_time(const PassportInput& input, const RowRange& range, Value value) {
  std::vector<ChartPoint> points;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double y = value(i), time_s = input.rows[i].time_s;
    if (!std::isfinite(y)) continue;
    if (!points.empty() && time_s - points.back().x > kBridged_s) points.push_back({time_s, kBreak});
    points.push_back({time_s, y});
  }
  return points;
}

bool has_force_and_depth(const Measurement& m) noexcept {
  return m.state == CellState::kContact && std::isfinite(m.contact_force_uN) && std::isfinite(m.indentation_um);
}

std::string with_unit(double value, const char* unit) {
  return fixed_number(value, decimals_of(value)) + ' ' + unit_text(unit);
}

std::vector<ChartMark> moments(const CellPassport& cell) {
  std::vector<ChartMark> marks;
  for (const ContactPassport& contact : cell.contact_list) {
    marks.push_back({contact.touch_s, "touch"});
    if (!std::isnan(contact.puncture_s)) marks.push_back({contact.puncture_s, "puncture"});
    if (!std::isnan(contact.release_s)) marks.push_back({contact.release_s, "release"});
    // More would be unreadable.
    if (marks.size() > 6) break;
  }
  return marks;
}

Chart force_over_time(const PassportInput& input, const CellPassport& cell, const RowRange& range) {
  Chart chart;
  chart.title = "Force over time";
  chart.x_label = "time (s)";
  chart.y_label = "force (" + unit_text("uN") + ")";
  const auto force_uN = [&](std::size_t i) { return input.rows[i].contact_force_uN; };
  chart.lines.push_back({over_time(input, range, force_uN), "curve", ""});
  ChartBand band, picture;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const Measurement& m = input.rows[i];
    if (!m.state) continue;
    if (!band.slices.empty() && m.time_s - band.slices.back().x > kBridged_s) {
      band.slices.push_back({m.time_s, kBreak, kBreak});
      picture.slices.push_back({m.time_s, kBreak, kBreak});
    }
    if (!std::isfinite(m.contact_force_uN)) continue;
    const bool has_interval = std::isfinite(m.contact_force_lower_uN) && std::isfinite(m.contact_force_upper_uN);
    band.slices.push_back({m.time_s, has_interval ? m.contact_force_lower_uN : m.contact_force_uN,
                           has_interval ? m.contact_force_upper_uN : m.contact_force_uN});
    const bool has_parts = std::isfinite(m.contact_force_picture_lower_uN);
    picture.slices.push_back({m.time_s, has_parts ? m.contact_force_picture_lower_uN : m.contact_force_uN,
                              has_parts ? m.contact_force_picture_upper_uN : m.contact_force_uN});
  }
  chart.bands = {std::move(band), std::move(picture)};
  chart.marks = moments(cell);
  chart.x_held = {input.rows[range.begin].time_s, input.rows[range.end - 1].time_s};
  const ContactPassport& main = cell.main_contact();
  if (!std::isnan(main.peak_force_uN)) {
    chart.dots.push_back({main.peak_force_s, main.peak_force_uN, with_unit(main.peak_force_uN, "uN")});
  }
  return chart;
}

Chart force_over_depth(const PassportInput& input, const CellPassport& cell) {
  Chart chart;
  chart.title = "Force over indentation";
  chart.x_label = "indentation (" + unit_text("um") + ")";
  chart.y_label = "force (" + unit_text("uN") + ")";
  chart.x_held = {0.0};
  const ContactPassport& main = cell.main_contact();
  ChartLine insertion{{}, "curve", "insertion"}, removal{{}, "removal", "removal"};
  ChartBand band, picture;
  for (std::size_t i = main.rows.begin; i < main.rows.end; ++i) {
    const Measurement& m = input.rows[i];
    if (!has_force_and_depth(m)) continue;
    const ChartPoint point{m.indentation_um, m.contact_force_uN};
    if (i < main.insertion.end) {
      insertion.points.push_back(point);
      // A depth that jitters back would fold the band.
      const bool is_further = band.slices.empty() || m.indentation_um > band.slices.back().x;
      if (is_further && std::isfinite(m.contact_force_lower_uN) && std::isfinite(m.contact_force_upper_uN)) {
        band.slices.push_back({m.indentation_um, m.contact_force_lower_uN, m.contact_force_upper_uN});
        const bool has_parts = std::isfinite(m.contact_force_picture_lower_uN);
        picture.slices.push_back({m.indentation_um, has_parts ? m.contact_force_picture_lower_uN : m.contact_force_uN,
                                  has_parts ? m.contact_force_picture_upper_uN : m.contact_force_uN});
      }
    } else if (std::isnan(main.puncture_s) || m.time_s < main.puncture_s) {
      if (removal.points.empty() && !insertion.points.empty()) removal.points.push_back(insertion.points.back());
      removal.points.push_back(point);
    }
  }
  chart.bands = {std::move(band), std::move(picture)};
  if (removal.points.empty()) insertion.label = "";
  chart.lines = {std::move(insertion), std::move(removal)};
  if (!std::isnan(main.puncture_force_uN)) {
    chart.dots.push_back(
        {main.puncture_depth_um, main.puncture_force_uN, "puncture, " + with_unit(main.puncture_depth_um, "um")});
  } else if (!std::isnan(main.peak_force_uN)) {
    chart.dots.push_back(
        {main.peak_force_depth_um, main.peak_force_uN, "peak, " + with_unit(main.peak_force_depth_um, "um")});
  }
  return chart;
}

Chart of_membrane(const PassportInput& input, const CellPassport& cell, const RowRange& range, const char* title,
                  const std::string& y_label, double MembraneState::*member) {
  Chart chart;
  chart.title = title;
  chart.x_label = "time (s)";
  chart.y_label = y_label;
  const auto value = [&](std::size_t i) { return input.membrane.empty() ? kBreak : input.membrane[i].*member; };
  chart.lines.push_back({over_time(input, range, value), "curve", ""});
  chart.marks = moments(cell);
  chart.x_held = {input.rows[range.begin].time_s, input.rows[range.end - 1].time_s};
  return chart;
}

}  // namespace

std::string cell_charts(const PassportInput& input, const CellPassport& cell) {
  if (cell.contact_list.empty()) return "";
  const RowRange range = shown_rows(input, cell);
  std::string html = "<div class=\"charts\">\n";
  html += svg_of(force_over_time(input, cell, range));
  html += svg_of(force_over_depth(input, cell));
  html += svg_of(of_membrane(input, cell, range, "Area strain of the outer membrane", "area strain (%)",
                             &MembraneState::area_strain_percent));
  html += svg_of(of_membrane(input, cell, range, "Mean tension of the outer membrane",
                             "tension (" + unit_text("uN/um") + ")", &MembraneState::mean_tension_uN_per_um));
  return html + "</div>\n";
}

std::string comparison_chart(const PassportInput& input, std::span<const CellPassport> cells) {
  Chart chart;
  chart.title = "Force over indentation on the way in, all cells";
  chart.x_label = "indentation (" + unit_text("um") + ")";
  chart.y_label = "force (" + unit_text("uN") + ")";
  chart.x_held = {0.0};
  for (const CellPassport& cell : cells) {
    const ContactPassport& main = cell.main_contact();
    if (std::isnan(main.peak_force_uN)) continue;
    ChartLine line{{}, "curve thin", ""};
    for (std::size_t i = main.insertion.begin; i < main.insertion.end; ++i) {
      const Measurement& m = input.rows[i];
      if (has_force_and_depth(m)) line.points.push_back({m.indentation_um, m.contact_force_uN});
    }
    chart.lines.push_back(std::move(line));
    chart.dots.push_back({main.peak_force_depth_um, main.peak_force_uN, "cell " + std::to_string(cell.cell)});
  }
  if (chart.lines.size() < 2) return "";
  // More names would cover one another.
  if (chart.dots.size() > kMostNamed) chart.dots.clear();
  return "<div class=\"charts one\">\n" + svg_of(chart) + "</div>\n";
}

}  // namespace pellucida
