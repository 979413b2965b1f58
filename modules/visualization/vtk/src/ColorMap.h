#pragma once
#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <string>

#include "pellucida/visualization/Palette.h"
#include "pellucida/visualization_vtk/HudCanvas.h"

namespace pellucida {

/// Colour scales from small to large; the first two are monotonic in lightness and light enough for a dark ground.
enum class ColorMapKind {
  kForce,    ///< violet, magenta, orange, pale yellow: arrows
  kSurface,  ///< blue, teal, green, pale lime: tension and displacement on the membrane
  kPull,     ///< blue, grey, red: signed, zero in the middle; from a push of the scale's end to a pull of it
};

/// Colour at `t` in 0..1 (clamped) on the ground of `theme`: on a light one the greatest is the darkest.
Color color_at(ColorMapKind kind, double t, const ThemeColors& theme = current_theme()) noexcept;

/// A table of 256 colours over 0..1; its range is set by `SetTableRange`.
vtkSmartPointer<vtkLookupTable> make_lookup_table(ColorMapKind kind);
/// Fills it again for the current theme.
void fill_lookup_table(vtkLookupTable* table, ColorMapKind kind);

/// An upright colour scale with title and five labels from 0 (kPull: -`upper`) to `upper`, lower left corner at (x, y),
/// bar `height_px` high. Stands at the view edge `side`; takes about 110 logical pixels in width. `open_end`: some
/// values lie beyond the scale, which the last label says.
void draw_color_bar(HudCanvas& hud, ColorMapKind kind, double x, double y, double height_px, double upper,
                    const std::string& title, HudAlign side, bool open_end = false,
                    const ThemeColors& theme = current_theme());

}  // namespace pellucida
