#include "WindowPicture.h"

#include <QPainter>
#include <QWidget>
#include <cmath>

#include "widgets/ViewWidget.h"

namespace pellucida {

QImage window_picture(QWidget& window, int width_px) {
  const double scale = static_cast<double>(width_px) / window.width();
  QImage picture(width_px, static_cast<int>(std::lround(scale * window.height())), QImage::Format_RGB32);
  picture.setDevicePixelRatio(scale);
  window.render(&picture);
  QPainter painter(&picture);
  // What the widgets hold of the views is as large as the screen shows it.
  for (ViewWidget* view : ViewWidget::all_in(window)) {
    if (!view->isVisible()) continue;
    const QRect place(view->mapTo(&window, QPoint(0, 0)), view->size());
    painter.drawImage(QRectF(place), view->picture((QSizeF(place.size()) * scale).toSize()));
  }
  return picture;
}

}  // namespace pellucida
