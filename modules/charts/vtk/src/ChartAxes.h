#pragma once
#include <string>

#include "pellucida/visualization/Palette.h"

class vtkAxis;
class vtkPen;

namespace pellucida {

/// Pixels that a tick's label needs.
inline constexpr double kTickRoomAcross_px = 90.0;
inline constexpr double kTickRoomUp_px = 36.0;

void set_color(vtkPen* pen, const Color& color, double opacity = 1.0);

/// The end of an axis from 0: close above the data, on a round number.
double axis_end(double greatest, double least_end);

/// Title, letters and lines of a chart's axis; `ratio`: device pixels a logical one.
void style_axis(vtkAxis* axis, const std::string& title, const ThemeColors& theme, double ratio);

/// The axis from `begin` to `end`, its ticks on round numbers, as many as have room at `spacing_px` each.
void set_ticks(vtkAxis* axis, double begin, double end, double length_px, double spacing_px);

}  // namespace pellucida
