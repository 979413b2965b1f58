#include "pellucida/charts_vtk/ChartPicture.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPDFExporter.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotPoints.h>
#include <vtkRect.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <system_error>

#include "ChartAxes.h"
#include "pellucida/core/Error.h"
#include "pellucida/core/OutputFile.h"
#include "pellucida/visualization/VirtualDisplay.h"
#include "pellucida/visualization_vtk/Letters.h"
#include "pellucida/visualization_vtk/MessageLog.h"

namespace pellucida {
namespace {

constexpr Color kInk = Color::from_hex(0x1B1F24);
constexpr Color kFineInk = Color::from_hex(0xD9DDE2);
/// One size for all: at 16 the bundled text renderer leaves a stripe of each label under it.
constexpr int kLetterSize = 17;
constexpr int kTitleSize = 20;
/// Round each chart, pixels.
constexpr float kMargin = 12.0F;
/// Ticks an axis has at most.
constexpr double kMostTicks = 7.0;

void set_letters(vtkTextProperty* letters, int size, bool bold) {
  letters->SetFontSize(size);
  letters->SetColor(kInk.red, kInk.green, kInk.blue);
  set_typeface(letters, bold);
}

void set_axis(vtkAxis* axis, const std::string& title, double begin, double end) {
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  set_letters(axis->GetTitleProperties(), kLetterSize, false);
  set_letters(axis->GetLabelProperties(), kLetterSize, false);
  axis->GetPen()->SetColorF(kInk.red, kInk.green, kInk.blue);
  axis->GetPen()->SetWidth(1.5F);
  axis->GetGridPen()->SetColorF(kFineInk.red, kFineInk.green, kFineInk.blue);
  axis->GetGridPen()->SetWidth(1.0F);
  set_ticks(axis, begin, end, kMostTicks, 1.0);
}

vtkNew<vtkTable> table_of(const ChartSeries& series) {
  const bool band = series.style == ChartStyle::kBand;
  if (series.x.size() != series.y.size() || (band && series.x.size() != series.y_upper.size())) {
    throw UsageError("chart: the columns of \"" + series.name + "\" differ in length");
  }
  vtkNew<vtkTable> table;
  const auto add = [&](const char* name, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (const double value : values) column->InsertNextValue(value);
    table->AddColumn(column);
  };
  add("x", series.x);
  add("y", series.y);
  if (band) add("y_upper", series.y_upper);
  return table;
}

void add_series(vtkChartXY* chart, const ChartSeries& series) {
  const vtkNew<vtkTable> table = table_of(series);
  const Color& c = series.color;
  vtkPlot* plot = nullptr;
  if (series.style == ChartStyle::kBand) {
    auto* area = vtkPlotArea::SafeDownCast(chart->AddPlot(vtkChart::AREA));
    area->SetInputData(table);
    area->SetInputArray(0, "x");
    area->SetInputArray(1, "y");
    area->SetInputArray(2, "y_upper");
    area->GetBrush()->SetColorF(c.red, c.green, c.blue, series.opacity);
    area->GetPen()->SetColorF(c.red, c.green, c.blue, 0.0);
    plot = area;
  } else if (series.style == ChartStyle::kPoints) {
    auto* points = vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::POINTS));
    points->SetInputData(table, 0, 1);
    points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    points->SetMarkerSize(static_cast<float>(series.width_px));
    points->GetPen()->SetColorF(c.red, c.green, c.blue);
    plot = points;
  } else {
    plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->SetWidth(static_cast<float>(series.width_px));
    plot->GetPen()->SetColorF(c.red, c.green, c.blue);
    if (series.style == ChartStyle::kDashedLine) plot->GetPen()->SetLineType(vtkPen::DASH_LINE);
  }
  plot->SetLabel(series.name);
  plot->SetLegendVisibility(!series.name.empty());
}

void fill(vtkChartXY* chart, const ChartPanel& panel) {
  chart->SetTitle(panel.title);
  set_letters(chart->GetTitleProperties(), kTitleSize, true);
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), panel.x_title, panel.x_begin, panel.x_end);
  set_axis(chart->GetAxis(vtkAxis::LEFT), panel.y_title, panel.y_begin, panel.y_end);
  for (const ChartSeries& series : panel.series) add_series(chart, series);
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetHorizontalAlignment(panel.legend_right ? vtkChartLegend::RIGHT : vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(panel.legend_bottom ? vtkChartLegend::BOTTOM : vtkChartLegend::TOP);
  legend->SetLabelSize(kLetterSize);
  legend->SetSymbolWidth(34);
  legend->SetDragEnabled(false);
  set_letters(legend->GetLabelProperties(), kLetterSize, false);
  legend->GetBrush()->SetColorF(1.0, 1.0, 1.0, 0.9);
  legend->GetPen()->SetColorF(kFineInk.red, kFineInk.green, kFineInk.blue);
  chart->SetHiddenAxisBorder(24);
}

// The exporters report a file they can't write to the log alone: what they leave is looked at.
void save_drawing(vtkRenderWindow* window, const std::filesystem::path& file, const std::string& kind) {
  OutputFile output(file);
  if (kind == ".svg") {
    vtkNew<vtkSVGExporter> exporter;
    exporter->SetRenderWindow(window);
    exporter->SetFileName(output.temporary().c_str());
    exporter->Write();
  } else {
    vtkNew<vtkPDFExporter> exporter;
    exporter->SetRenderWindow(window);
    exporter->SetFileName(output.temporary().c_str());
    exporter->Write();
  }
  std::error_code unknown;
  if (std::filesystem::file_size(output.temporary(), unknown) == 0 || unknown) {
    throw OutputError(file.string() + ": the chart can't be written; free some space, or choose another folder");
  }
  output.finish();
}

}  // namespace

void render_charts(std::span<const ChartPanel> panels, int columns, const std::filesystem::path& file,
                   const PictureSize& size) {
  check_picture_size(size);
  const std::string kind = file.extension().string();
  if (kind != ".png" && kind != ".svg" && kind != ".pdf") {
    throw UsageError(file.string() + ": a chart is written as .png, .svg or .pdf; choose one of these endings");
  }
  if (panels.empty() || columns < 1) throw UsageError("charts: there is nothing to draw");
  MessageLog::install();
  VirtualDisplay display;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(size.width_px, size.height_px);
  window->SetMultiSamples(4);

  const int count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  for (int k = 0; k < count; ++k) {
    const int row = k / columns, column = k % columns;
    vtkNew<vtkRenderer> part;
    part->SetBackground(1.0, 1.0, 1.0);
    part->SetViewport(static_cast<double>(column) / columns, 1.0 - static_cast<double>(row + 1) / rows,
                      static_cast<double>(column + 1) / columns, 1.0 - static_cast<double>(row) / rows);
    vtkNew<vtkContextActor> actor;
    vtkNew<vtkChartXY> chart;
    actor->GetScene()->AddItem(chart);
    actor->GetScene()->SetRenderer(part);
    part->AddActor(actor);
    window->AddRenderer(part);
    fill(chart, panels[static_cast<std::size_t>(k)]);
    chart->SetAutoSize(false);
    chart->SetSize(vtkRectf(kMargin, kMargin,
                            static_cast<float>(size.width_px) / static_cast<float>(columns) - 2.0F * kMargin,
                            static_cast<float>(size.height_px) / static_cast<float>(rows) - 2.0F * kMargin));
  }
  window->Render();
  if (kind == ".png") {
    save_window(window, file);
  } else {
    save_drawing(window, file, kind);
  }
}

}  // namespace pellucida
