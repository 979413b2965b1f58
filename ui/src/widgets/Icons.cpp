#include "widgets/Icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include "Theme.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

// Each pictogram lives on a field of 16 x 16.
constexpr double kField = 16.0;

void draw(QPainter& painter, Pictogram pictogram) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(to_qt(palette::kText));
  switch (pictogram) {
    case Pictogram::kProgram:
      // A cell in its clear zone, touched from the right.
      painter.setBrush(to_qt(palette::kPanel));
      painter.drawRoundedRect(QRectF(0, 0, 16, 16), 3.5, 3.5);
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(to_qt(palette::kOuter), 1.3));
      painter.drawEllipse(QPointF(7.2, 8.0), 5.2, 5.2);
      painter.setPen(Qt::NoPen);
      painter.setBrush(to_qt(palette::kInner));
      painter.drawEllipse(QPointF(7.2, 8.0), 3.4, 3.4);
      painter.setBrush(to_qt(palette::kText));
      painter.drawPolygon(QPolygonF({{8.6, 8.0}, {15.6, 7.0}, {15.6, 9.0}}));
      break;
    case Pictogram::kRecord:
      painter.setBrush(to_qt(palette::kRecord));
      painter.drawEllipse(QPointF(8, 8), 5, 5);
      break;
    case Pictogram::kStop:
      painter.setBrush(to_qt(palette::kWindow));
      painter.drawRect(QRectF(4, 4, 8, 8));
      break;
    case Pictogram::kPause:
      painter.drawRect(QRectF(4, 3, 3, 10));
      painter.drawRect(QRectF(9, 3, 3, 10));
      break;
    case Pictogram::kPlay:
      painter.drawPolygon(QPolygonF({{4.5, 2.5}, {13, 8}, {4.5, 13.5}}));
      break;
    case Pictogram::kCamera: {
      QPainterPath body;
      body.addRoundedRect(QRectF(1.5, 4.5, 13, 9), 1.8, 1.8);
      body.addRect(QRectF(5.5, 2.8, 5, 1.8));
      painter.drawPath(body.simplified());
      painter.setBrush(to_qt(palette::kRaised));
      painter.drawEllipse(QPointF(8, 9), 2.8, 2.8);
      break;
    }
    case Pictogram::kRestart:
      // To the first frame: a bar, and a triangle pointing at it.
      painter.drawRect(QRectF(3, 3, 2.4, 10));
      painter.drawPolygon(QPolygonF({{13.5, 2.5}, {6.2, 8}, {13.5, 13.5}}));
      break;
    case Pictogram::kNote:
      painter.drawRect(QRectF(3, 3, 10, 1.6));
      painter.drawRect(QRectF(3, 7, 10, 1.6));
      painter.drawRect(QRectF(3, 11, 6, 1.6));
      break;
  }
}

}  // namespace

QIcon make_icon(Pictogram pictogram) {
  QIcon icon;
  for (const int size : {16, 32, 64, 128}) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / kField, size / kField);
    draw(painter, pictogram);
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace pellucida
