#include "widgets/ElidedLabel.h"

#include <QPainter>

namespace pellucida {

ElidedLabel::ElidedLabel(Qt::TextElideMode mode, QWidget* parent) : QLabel(parent), mode_(mode) {
  setTextFormat(Qt::PlainText);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {0, QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(contentsRect(), static_cast<int>(Qt::AlignRight | Qt::AlignVCenter),
                   fontMetrics().elidedText(text(), mode_, contentsRect().width()));
}

}  // namespace pellucida
