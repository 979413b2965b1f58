#pragma once

class QApplication;
class QColor;

namespace pellucida {

struct Color;

/// A palette's colour for Qt.
QColor to_qt(const Color& color);

/// Dark theme: Fusion style, palette and style sheet from `pellucida::palette`.
void apply_theme(QApplication& app);

}  // namespace pellucida
