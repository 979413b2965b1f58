#include "ChartAxes.h"

#include <vtkAxis.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStringArray.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "pellucida/core/RoundNumbers.h"
#include "pellucida/visualization/Readout.h"
#include "pellucida/visualization_vtk/Letters.h"

namespace pellucida {

void set_color(vtkPen* pen, const Color& color, double opacity) {
  pen->SetColorF(color.red, color.green, color.blue, opacity);
}

double axis_end(double greatest, double least_end) {
  if (!(greatest > least_end)) return least_end;
  const double decade = std::pow(10.0, std::floor(std::log10(greatest)));
  for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0}) {
    if (greatest <= step * decade) return step * decade;
  }
  return 10.0 * decade;
}

void style_axis(vtkAxis* axis, const std::string& title, const ThemeColors& theme, double ratio) {
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  for (vtkTextProperty* letters : {axis->GetTitleProperties(), axis->GetLabelProperties()}) {
    const Color& c = letters == axis->GetTitleProperties() ? theme.text : theme.text_dim;
    letters->SetFontSize(static_cast<int>(std::lround(font_size::kSmall * ratio)));
    set_typeface(letters, false);
    letters->SetColor(c.red, c.green, c.blue);
  }
  axis->GetPen()->SetWidth(static_cast<float>(ratio));
  axis->GetGridPen()->SetWidth(static_cast<float>(ratio));
  set_color(axis->GetPen(), theme.border);
  set_color(axis->GetGridPen(), theme.grid);
}

void set_ticks(vtkAxis* axis, double begin, double end, double length_px, double spacing_px) {
  const double most = std::max(2.0, length_px / spacing_px);
  const double step = nice_ceiling((end - begin) / most, 1e-9);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (double at = std::ceil(begin / step - 1e-6) * step; at <= end + 1e-6 * step; at += step) {
    places->InsertNextValue(at);
    labels->InsertNextValue(readout::plain(std::abs(at) < 1e-9 * step ? 0.0 : at));
  }
  axis->SetRange(begin, end);
  axis->SetCustomTickPositions(places, labels);
}

}  // namespace pellucida
