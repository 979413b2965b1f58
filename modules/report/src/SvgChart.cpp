#include "SvgChart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "pellucida/core/Html.h"
#include "pellucida/core/RoundNumbers.h"

namespace pellucida {
namespace {

// In units of the drawing, which a page scales.
constexpr double kWidth = 460.0, kHeight = 216.0;
constexpr double kLeft = 56.0, kRight = 14.0, kTop = 40.0, kBottom = 40.0;
constexpr double kCharacter = 6.6;  // about the width of one
constexpr double kUnseen = 0.03;    // of the largest value
constexpr std::size_t kMostDrawn = 900;

// A session may hold any number; what no axis can bear is left out like what is missing.
bool is_drawable(double value) noexcept {
  return std::abs(value) < 1e12;
}

struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void hold(double value) noexcept {
    if (!is_drawable(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const noexcept { return low > high; }
  void widen_if_flat() noexcept {
    if (high - low > 1e-9 * std::max(1.0, std::abs(high))) return;
    low -= 0.5;
    high += 0.5;
  }
};

std::string digits(double value) {
  return fixed_number(value, 1);
}

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + digits(value) + '"';
}

// Of each group of neighbours the first, the least, the largest and the last; a break stays one.
std::vector<ChartPoint> thinned(const std::vector<ChartPoint>& points) {
  if (points.size() <= kMostDrawn) return points;
  const std::size_t size = (4 * points.size() + kMostDrawn - 1) / kMostDrawn;
  std::vector<ChartPoint> kept;
  for (std::size_t begin = 0; begin < points.size(); begin += size) {
    const std::size_t end = std::min(begin + size, points.size());
    std::size_t least = begin, most = begin;
    bool breaks = false;
    for (std::size_t i = begin; i < end; ++i) {
      if (std::isnan(points[i].y)) {
        breaks = true;
        continue;
      }
      if (!(points[i].y >= points[least].y)) least = i;
      if (!(points[i].y <= points[most].y)) most = i;
    }
    for (const std::size_t i : {begin, std::min(least, most), std::max(least, most), end - 1}) {
      if (!std::isnan(points[i].y)) kept.push_back(points[i]);
    }
    if (breaks) kept.push_back({points[end - 1].x, std::numeric_limits<double>::quiet_NaN()});
  }
  return kept;
}

// The same for a band: the widest of each group.
std::vector<ChartBand::Slice> thinned(const std::vector<ChartBand::Slice>& slices) {
  if (slices.size() <= kMostDrawn) return slices;
  const std::size_t size = (2 * slices.size() + kMostDrawn - 1) / kMostDrawn;
  std::vector<ChartBand::Slice> kept;
  for (std::size_t begin = 0; begin < slices.size(); begin += size) {
    ChartBand::Slice widest = slices[begin];
    for (std::size_t i = begin; i < std::min(begin + size, slices.size()); ++i) {
      if (std::isnan(slices[i].lower)) {
        widest = slices[i];
        break;
      }
      widest.lower = std::min(widest.lower, slices[i].lower);
      widest.upper = std::max(widest.upper, slices[i].upper);
    }
    kept.push_back(widest);
  }
  return kept;
}

class ChartWriter {
 public:
  explicit ChartWriter(const Chart& chart) : chart_(chart) {}

  std::string write() {
    measure();
    if (x_.empty() || y_.empty()) {
      return "<p class=\"none\">" + html_text(chart_.title) + ": not recorded.</p>\n";
    }
    svg_ = "<svg class=\"chart\" viewBox=\"0 0 " + digits(kWidth) + ' ' + digits(kHeight) +
           "\" role=\"img\" aria-label=\"" + html_text(chart_.title) + "\">\n";
    text(kLeft, 16.0, "title", "start", chart_.title);
    write_axes();
    write_legend();
    write_marks();
    for (const ChartBand& band : chart_.bands) write_band(thinned(band.slices));
    for (const ChartLine& line : chart_.lines) write_line(line);
    write_dots();
    return svg_ + "</svg>\n";
  }

 private:
  void measure() {
    for (const ChartLine& line : chart_.lines) {
      for (const ChartPoint& point : line.points) {
        if (!is_drawable(point.x) || !is_drawable(point.y)) continue;
        x_.hold(point.x);
        y_.hold(point.y);
      }
    }
    for (const ChartBand& band : chart_.bands) {
      for (const auto& slice : band.slices) {
        y_.hold(slice.lower);
        y_.hold(slice.upper);
      }
    }
    if (x_.empty() || y_.empty()) return;
    for (const double x : chart_.x_held) x_.hold(x);
    y_.hold(0.0);
    // Noise about 0 needs no room of its own.
    if (y_.low > -kUnseen * y_.high) y_.low = 0.0;
    x_.widen_if_flat();
    y_.widen_if_flat();
    // The scale ends at a round number.
    const auto ticks = round_ticks(y_.low, y_.high, TickEnds::kOutside);
    y_ = {ticks.front(), ticks.back()};
  }

  double px(double x) const noexcept { return kLeft + (kWidth - kLeft - kRight) * (x - x_.low) / (x_.high - x_.low); }
  double py(double y) const noexcept {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * (y - y_.low) / (y_.high - y_.low);
  }

  void text(double x, double y, const char* style, const char* anchor, const std::string& words,
            const std::string& more = "") {
    svg_ += "<text" + attribute("x", x) + attribute("y", y) + " class=\"" + style + "\" text-anchor=\"" + anchor + '"' +
            more + '>' + html_text(words) + "</text>\n";
  }

  void line(double x1, double y1, double x2, double y2, const char* style) {
    svg_ += "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
            " class=\"" + style + "\"/>\n";
  }

  void write_axes() {
    const double bottom = kHeight - kBottom, right = kWidth - kRight;
    const auto y_ticks = round_ticks(y_.low, y_.high, TickEnds::kInside),
               x_ticks = round_ticks(x_.low, x_.high, TickEnds::kInside);
    for (const double tick : y_ticks) {
      line(kLeft, py(tick), right, py(tick), "grid");
      text(kLeft - 6.0, py(tick) + 4.0, "tick", "end", tick_text(tick, y_ticks));
    }
    for (const double tick : x_ticks) {
      line(px(tick), bottom, px(tick), bottom + 4.0, "axis");
      text(px(tick), bottom + 17.0, "tick", "middle", tick_text(tick, x_ticks));
    }
    line(kLeft, bottom, right, bottom, "axis");
    text(0.5 * (kLeft + right), kHeight - 6.0, "label", "middle", chart_.x_label);
    const double middle = 0.5 * (kTop + bottom);
    text(14.0, middle, "label", "middle", chart_.y_label, " transform=\"rotate(-90 14 " + digits(middle) + ")\"");
  }

  static std::string tick_text(double tick, const std::vector<double>& ticks) {
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
    return fixed_number(tick, std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))));
  }

  void write_legend() {
    double x = kWidth - kRight;
    for (std::size_t i = chart_.lines.size(); i-- > 0;) {
      const ChartLine& one = chart_.lines[i];
      if (one.label.empty() || one.points.empty()) continue;
      text(x, 16.0, "tick", "end", one.label);
      x -= kCharacter * static_cast<double>(one.label.size()) + 6.0;
      line(x - 18.0, 12.0, x, 12.0, one.style.c_str());
      x -= 32.0;
    }
  }

  // Words above the plot; where two would meet, the next is a little lower.
  void write_marks() {
    double taken_to = 0.0;
    bool lower = false;
    for (const ChartMark& mark : chart_.marks) {
      if (!(mark.x >= x_.low && mark.x <= x_.high)) continue;
      line(px(mark.x), kTop - 4.0, px(mark.x), kHeight - kBottom, "mark");
      const double half = 0.5 * kCharacter * static_cast<double>(mark.label.size());
      const double center = std::clamp(px(mark.x), kLeft + half, kWidth - kRight - half);
      lower = center - half < taken_to && !lower;
      text(center, lower ? kTop + 8.0 : kTop - 8.0, "word", "middle", mark.label);
      taken_to = center + half + 4.0;
    }
  }

  void write_band(const std::vector<ChartBand::Slice>& slices) {
    for (std::size_t begin = 0; begin < slices.size();) {
      std::size_t end = begin;
      while (end < slices.size() && is_drawable(slices[end].x) && is_drawable(slices[end].lower) &&
             is_drawable(slices[end].upper))
        ++end;
      if (end > begin + 1) {
        svg_ += "<polygon class=\"band\" points=\"";
        for (std::size_t i = begin; i < end; ++i) point(slices[i].x, slices[i].upper);
        for (std::size_t i = end; i-- > begin;) point(slices[i].x, slices[i].lower);
        svg_ += "\"/>\n";
      }
      begin = end + 1;
    }
  }

  void write_line(const ChartLine& one) {
    const auto points = thinned(one.points);
    for (std::size_t begin = 0; begin < points.size();) {
      std::size_t end = begin;
      while (end < points.size() && is_drawable(points[end].x) && is_drawable(points[end].y)) {
        ++end;
      }
      if (end > begin) {
        svg_ += "<polyline class=\"" + one.style + "\" points=\"";
        for (std::size_t i = begin; i < end; ++i) point(points[i].x, points[i].y);
        // A point by itself shows, too.
        if (end == begin + 1) point(points[begin].x, points[begin].y);
        svg_ += "\"/>\n";
      }
      begin = end + 1;
    }
  }

  void point(double x, double y) { svg_ += digits(px(x)) + ',' + digits(py(y)) + ' '; }

  void write_dots() {
    for (const ChartDot& dot : chart_.dots) {
      if (!is_drawable(dot.x) || !is_drawable(dot.y)) continue;
      svg_ += "<circle" + attribute("cx", px(dot.x)) + attribute("cy", py(dot.y)) + " r=\"3.5\" class=\"dot\"/>\n";
      const bool at_right = px(dot.x) > 0.6 * kWidth;
      text(px(dot.x) + (at_right ? -8.0 : 8.0), std::max(py(dot.y) - 7.0, kTop + 10.0), "word",
           at_right ? "end" : "start", dot.label);
    }
  }

  const Chart& chart_;
  Span x_, y_;
  std::string svg_;
};

}  // namespace

std::string svg_of(const Chart& chart) {
  return ChartWriter(chart).write();
}

}  // namespace pellucida
