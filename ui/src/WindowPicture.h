#pragma once
#include <QImage>

class QWidget;

namespace pellucida {

/// A widget as it is shown, `width_px` wide (its height follows): widgets and letters drawn at that size, each view
/// rendered at its own. The window's thread.
QImage window_picture(QWidget& window, int width_px);

}  // namespace pellucida
