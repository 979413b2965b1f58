#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pellucida/charts_vtk/CurveChart.h"
#include "pellucida/core/Measurement.h"

class vtkPolyData;

namespace pellucida {

/// A chart as a table: `curve`, the two axes as they are titled, `lower`, `upper`; a row a point, a gap left out.
/// Throws OutputError.
void write_chart_table(const CurveChartData& chart, const std::filesystem::path& file);

/// A chart that the window shows; `name` becomes its file's.
struct SeenChart {
  std::string name;
  CurveChartData data;
};

/// What the window shows of one frame.
struct SeenFrame {
  Measurement row;
  vtkPolyData* surface = nullptr;  ///< null: none
  std::optional<long> node;        ///< the one that is picked
  std::vector<SeenChart> charts;
};

/// The files that `write_seen` writes: `frame.csv` (the frame's row), `nodes.csv` (its surface, with the node picked
/// marked), and one for each chart.
std::vector<std::filesystem::path> seen_files(const SeenFrame& frame, const std::filesystem::path& folder);
/// Makes the folder. Throws OutputError.
void write_seen(const SeenFrame& frame, const std::filesystem::path& folder);

}  // namespace pellucida
