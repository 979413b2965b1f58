#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pellucida/charts_vtk/RenderPicture.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {

enum class ChartStyle { kLine, kDashedLine, kPoints, kBand };

/// One curve of a chart.
struct ChartSeries {
  std::string name;  ///< in the legend; empty: not there
  ChartStyle style = ChartStyle::kLine;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> y_upper;  ///< the band's other edge; for kBand only
  Color color;
  double opacity = 1.0;   ///< of a band, 0..1
  double width_px = 2.0;  ///< of a line, or a point's size
};

/// One chart: axes with their titles (and units), curves from the back to the front, a legend in a corner.
struct ChartPanel {
  std::string title;
  std::string x_title;
  std::string y_title;
  double x_begin = 0.0, x_end = 1.0;  ///< ends of the axes
  double y_begin = 0.0, y_end = 1.0;
  bool legend_right = false;   ///< left otherwise
  bool legend_bottom = false;  ///< top otherwise
  std::vector<ChartSeries> series;
};

/// Charts side by side in rows of `columns`, dark on white, for print, drawn off screen; whole or not at all. The
/// ending of `file` says as what: `.png` in dots, `.svg` or `.pdf` in lines that keep their sharpness. Needs an X
/// server, its own (VirtualDisplay) where there is none. Main thread only. Throws DeviceError when there is no way to
/// draw, OutputError when the file can't be written, UsageError for another ending, a size below 400 x 300 or above
/// 8000 x 8000, or a series whose columns differ in length.
void render_charts(std::span<const ChartPanel> panels, int columns, const std::filesystem::path& file,
                   const PictureSize& size = {});

}  // namespace pellucida
