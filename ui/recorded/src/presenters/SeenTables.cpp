#include "presenters/SeenTables.h"

#include <vtkPolyData.h>

#include <cmath>

#include "pellucida/core/OutputFile.h"
#include "pellucida/core/Table.h"
#include "presenters/SurfaceNode.h"

namespace pellucida {
namespace {

namespace fs = std::filesystem;

void add_points(OutputFile& output, const std::string& name, const Curve& curve) {
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::isnan(curve.y[i])) continue;
    output.add(csv_cell(name) + ',' + csv_number(curve.x[i]) + ',' + csv_number(curve.y[i]) + ',' +
               csv_number(curve.lower[i]) + ',' + csv_number(curve.upper[i]));
  }
}

void write_nodes(vtkPolyData* surface, std::optional<long> picked, const fs::path& file) {
  OutputFile output(file);
  output.add(
      "node,picked,membrane,x_um,y_um,z_um,fx_uN,fy_uN,fz_uN,force_uN,force_sigma_uN,tension_uN_per_um,"
      "displacement_um,tension_sigma_uN_per_um");
  for (long i = 0; i < surface->GetNumberOfPoints(); ++i) {
    const auto node = surface_node(surface, i);
    if (!node) continue;
    std::string line = std::to_string(i) + (picked == i ? ",1," : ",0,") +
                       (node->membrane ? std::to_string(static_cast<int>(*node->membrane)) : "");
    for (const auto* vector : {&node->place_um, &node->force_uN}) {
      for (const double value : *vector) line += ',' + csv_number(value);
    }
    for (const double value : {node->force_magnitude_uN, node->force_sigma_uN, node->tension_uN_per_um,
                               node->displacement_um, node->tension_sigma_uN_per_um}) {
      line += ',' + csv_number(value);
    }
    output.add(line);
  }
  output.finish();
}

}  // namespace

void write_chart_table(const CurveChartData& chart, const fs::path& file) {
  OutputFile output(file);
  output.add("curve," + csv_cell(chart.x_title) + ',' + csv_cell(chart.y_title) + ",lower,upper");
  add_points(output, chart.curve_name.empty() ? "measured" : chart.curve_name, chart.curve);
  add_points(output, chart.other_name.empty() ? "other" : chart.other_name, chart.other);
  for (const NamedCurve& named : chart.named) add_points(output, named.name, named.curve);
  add_points(output, "other touches", chart.faint);
  output.finish();
}

std::vector<fs::path> seen_files(const SeenFrame& frame, const fs::path& folder) {
  std::vector<fs::path> files{folder / "frame.csv"};
  if (frame.surface) files.push_back(folder / "nodes.csv");
  for (const SeenChart& chart : frame.charts) files.push_back(folder / (chart.name + ".csv"));
  return files;
}

void write_seen(const SeenFrame& frame, const fs::path& folder) {
  make_folder(folder);
  OutputFile output(folder / "frame.csv");
  output.add(measurement_header());
  output.add(to_csv(frame.row));
  output.finish();
  if (frame.surface) write_nodes(frame.surface, frame.node, folder / "nodes.csv");
  for (const SeenChart& chart : frame.charts) write_chart_table(chart.data, folder / (chart.name + ".csv"));
}

}  // namespace pellucida
