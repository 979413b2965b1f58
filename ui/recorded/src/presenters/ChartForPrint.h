#pragma once
#include "pellucida/charts_vtk/ChartPicture.h"
#include "pellucida/charts_vtk/CurveChart.h"

namespace pellucida {

/// A chart of the window as one for print, dark on white: the same curves, band and marks, the axes' ends on round
/// numbers.
ChartPanel chart_for_print(const CurveChartData& data, const std::string& title);

}  // namespace pellucida
