#pragma once

class QApplication;
class QColor;

namespace pellucida {

struct Color;
struct ThemeColors;

/// A palette's colour for Qt.
QColor to_qt(const Color& color);

/// Fusion style, palette and style sheet from a theme's colours; all letters `type_scale` times as large.
void apply_theme(QApplication& app, const ThemeColors& theme, double type_scale = 1.0);
/// The theme applied last; the dark one before.
const ThemeColors& current_theme() noexcept;

}  // namespace pellucida
