#pragma once

class QApplication;
class QColor;

namespace pellucida {

struct Color;
struct ThemeColors;

/// A palette's colour for Qt.
QColor to_qt(const Color& color);

/// Makes `theme` the current one: Fusion style, palette and style sheet from its colours; all letters `type_scale`
/// times as large. What is open follows.
void apply_theme(QApplication& app, const ThemeColors& theme, double type_scale = 1.0);
/// The scale of letters applied last; 1 before.
double applied_type_scale() noexcept;

}  // namespace pellucida
