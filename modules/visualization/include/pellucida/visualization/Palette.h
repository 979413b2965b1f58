#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "pellucida/core/Observation.h"

namespace pellucida {

/// A colour, each part in 0..1 (sRGB values, as VTK and Qt take them).
struct Color {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;

  /// From 0xRRGGBB.
  static constexpr Color from_hex(std::uint32_t rgb) noexcept {
    return {((rgb >> 16) & 0xFF) / 255.0, ((rgb >> 8) & 0xFF) / 255.0, (rgb & 0xFF) / 255.0};
  }
  /// For VTK calls that take three numbers.
  const double* data() const noexcept { return &red; }
  /// "#rrggbb", for style sheets.
  std::string css() const;
};
static_assert(sizeof(Color) == 3 * sizeof(double), "Color is handed to VTK as three numbers");

/// Contrast of two colours by WCAG 2: 1 (same) .. 21 (black on white). Text wants 4.5, large text and lines 3.
double contrast_ratio(const Color& a, const Color& b) noexcept;

/// The one place where the dark theme's colours are chosen; a test checks the contrasts of text.
namespace palette {
// Surfaces, from the back to the front.
inline constexpr Color kWindow = Color::from_hex(0x0F1318);
inline constexpr Color kPanel = Color::from_hex(0x171C23);
inline constexpr Color kRaised = Color::from_hex(0x222A34);
inline constexpr Color kBorder = Color::from_hex(0x303B48);
inline constexpr Color kViewBottom = Color::from_hex(0x0C1016);
inline constexpr Color kViewTop = Color::from_hex(0x1B2530);

// Writing.
inline constexpr Color kText = Color::from_hex(0xE8EDF3);
inline constexpr Color kTextDim = Color::from_hex(0x9DAAB9);
inline constexpr Color kAccent = Color::from_hex(0x58B7FF);
inline constexpr Color kRecord = Color::from_hex(0xFF5C5C);
inline constexpr Color kWarning = Color::from_hex(0xF5B950);

// Lines over the grey image; far apart in hue, and drawn on a dark underlay.
inline constexpr Color kOuter = Color::from_hex(0x39D5FF);
inline constexpr Color kInner = Color::from_hex(0xFFA94D);
inline constexpr Color kOolemma = Color::from_hex(0xD59BFF);
inline constexpr Color kNeedle = Color::from_hex(0xFF5F87);
inline constexpr Color kHolder = Color::from_hex(0x86E57F);
inline constexpr Color kPlan = Color::from_hex(0x8FA6FF);
inline constexpr Color kModel = Color::from_hex(0xFFF27A);

// Solids of the 3-D view.
inline constexpr Color kOuterSolid = Color::from_hex(0x8FD3F0);
inline constexpr Color kInnerSolid = Color::from_hex(0xD9A27E);
inline constexpr Color kGlass = Color::from_hex(0xB9C9D9);
inline constexpr Color kContactForce = Color::from_hex(0xFFFFFF);

// Curves of the charts.
inline constexpr Color kCurve = Color::from_hex(0x58B7FF);
inline constexpr Color kCurveBefore = Color::from_hex(0x56687B);
inline constexpr Color kCurveOther = Color::from_hex(0xFFA94D);
inline constexpr Color kGrid = Color::from_hex(0x26303B);
}  // namespace palette

/// The colours of a window that has a light theme too, by their use.
struct ThemeColors {
  Color window, panel, raised, border;
  Color view_bottom, view_top;
  Color text, text_dim, faint;
  Color accent, record, warning, good, plan;
  Color grid, curve, curve_before, curve_other;
  Color cell, glass;
  Color outer_solid, inner_solid, contact_force, node_mark, model, needle, droplet, unsure;  // of the 3-D view
  bool is_light = false;
};
/// The palette above.
const ThemeColors& dark_theme() noexcept;
/// Dark on white, for projectors; the same contrasts.
const ThemeColors& light_theme() noexcept;

/// The theme of this program's windows and of the views in them: the dark one until another is set.
const ThemeColors& current_theme() noexcept;
/// Set on the thread that draws, by who then has everything drawn again. `theme` is one of the two above.
void set_current_theme(const ThemeColors& theme) noexcept;

/// Colour of a state's pill and of its name in `theme`; text on the pill is the theme's `window`.
/// That of no cell for a frame that was not measured.
Color state_color(std::optional<CellState> state, const ThemeColors& theme = current_theme()) noexcept;

/// Sizes of letters in points at 72 dots an inch.
namespace font_size {
inline constexpr int kSmall = 12;
inline constexpr int kNormal = 13;
inline constexpr int kTitle = 15;
inline constexpr int kReadout = 22;
}  // namespace font_size

}  // namespace pellucida
