#pragma once
#include <string>
#include <vector>

namespace pellucida {

struct ChartPoint {
  double x = 0.0;
  double y = 0.0;  ///< NaN breaks the line
};

/// A line; its colour is that of its class in the page's style.
struct ChartLine {
  std::vector<ChartPoint> points;
  std::string style;  ///< class
  std::string label;  ///< in the legend; "" for none
};

/// A band between two curves.
struct ChartBand {
  struct Slice {
    double x = 0.0, lower = 0.0, upper = 0.0;  ///< NaN breaks the band
  };
  std::vector<Slice> slices;
};

/// A moment, as a line from top to bottom with a word.
struct ChartMark {
  double x = 0.0;
  std::string label;
};

/// A place on a curve, with a word.
struct ChartDot {
  double x = 0.0, y = 0.0;
  std::string label;
};

/// A small line chart. Every text is escaped.
struct Chart {
  std::string title;
  std::string x_label, y_label;  ///< with units
  std::vector<ChartBand> bands;
  std::vector<ChartLine> lines;
  std::vector<ChartMark> marks;
  std::vector<ChartDot> dots;
  std::vector<double> x_held;  ///< places that the x axis holds, whatever is drawn
};

/// The chart as an `svg` element that scales with the page; its y axis holds 0. Lines of more points than can be seen
/// are thinned, their peaks kept. A chart without a finite point is a sentence that says so.
std::string svg_of(const Chart& chart);

}  // namespace pellucida
