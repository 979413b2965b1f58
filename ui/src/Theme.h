#pragma once

class QApplication;
class QColor;
class QString;
class QWidget;

namespace pellucida {

struct Color;
struct ThemeColors;

/// A palette's colour for Qt.
QColor to_qt(const Color& color);

/// A style sheet for one widget; nothing happens where it has that one, since Qt would style it anew all the same.
void set_sheet(QWidget& widget, const QString& sheet);

/// Makes `theme` the current one: Fusion style, palette and style sheet from its colours; all letters `type_scale`
/// times as large. What is open follows.
void apply_theme(QApplication& app, const ThemeColors& theme, double type_scale = 1.0);
/// The scale of letters applied last; 1 before.
double applied_type_scale() noexcept;

}  // namespace pellucida
