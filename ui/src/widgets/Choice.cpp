#include "widgets/Choice.h"

#include <QPainter>
#include <QWheelEvent>

#include "Theme.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr int kArrowMargin_px = 9;

}  // namespace

void Choice::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

void Choice::paintEvent(QPaintEvent* event) {
  QComboBox::paintEvent(event);
  QPainter painter(this);
  painter.setPen(to_qt(isEnabled() ? current_theme().text_dim : current_theme().border));
  painter.drawText(rect().adjusted(0, 0, -kArrowMargin_px, 0), Qt::AlignRight | Qt::AlignVCenter,
                   QString::fromUtf8("\u25BE"));
}

}  // namespace pellucida
