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

// A triangle from `x0` to its tip at `x1`.
void draw_arrow(QPainter& painter, double x0, double x1) {
  painter.drawPolygon(QPolygonF({{x0, 3.0}, {x1, 8.0}, {x0, 13.0}}));
}

// A drawing for the way forwards; mirrored for the way back.
void draw_transport(QPainter& painter, Pictogram pictogram) {
  switch (pictogram) {
    case Pictogram::kStepForward:
      painter.drawRect(QRectF(3, 3, 2.2, 10));
      draw_arrow(painter, 7, 13);
      break;
    case Pictogram::kTenForward:
      draw_arrow(painter, 2.5, 8);
      draw_arrow(painter, 8, 13.5);
      break;
    case Pictogram::kEventForward:
      draw_arrow(painter, 2, 7);
      painter.drawPolygon(QPolygonF({{11, 4}, {15, 8}, {11, 12}, {7, 8}}));
      break;
    default:
      draw_arrow(painter, 3, 12);
      break;
  }
}

void draw_loop(QPainter& painter) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(to_qt(palette::kText), 1.7));
  painter.drawArc(QRectF(3, 3, 10, 10), 20 * 16, 300 * 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(to_qt(palette::kText));
  painter.drawPolygon(QPolygonF({{10.2, 7.0}, {15.4, 7.0}, {12.8, 2.6}}));
}

void mirror(QPainter& painter) {
  painter.translate(kField, 0.0);
  painter.scale(-1.0, 1.0);
}

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
    case Pictogram::kEnd:
      mirror(painter);
      draw(painter, Pictogram::kRestart);
      break;
    case Pictogram::kStepForward:
    case Pictogram::kTenForward:
    case Pictogram::kEventForward:
      draw_transport(painter, pictogram);
      break;
    case Pictogram::kStepBack:
      mirror(painter);
      draw_transport(painter, Pictogram::kStepForward);
      break;
    case Pictogram::kTenBack:
      mirror(painter);
      draw_transport(painter, Pictogram::kTenForward);
      break;
    case Pictogram::kEventBack:
      mirror(painter);
      draw_transport(painter, Pictogram::kEventForward);
      break;
    case Pictogram::kBackwards:
      mirror(painter);
      draw(painter, Pictogram::kPlay);
      break;
    case Pictogram::kLoop:
      draw_loop(painter);
      break;
    case Pictogram::kOpen:
      painter.drawPolygon(QPolygonF({{1.5, 3}, {6.5, 3}, {8, 5}, {14.5, 5}, {14.5, 13}, {1.5, 13}}));
      break;
    case Pictogram::kLesson:
      // An open book.
      painter.drawPolygon(QPolygonF({{1, 3.2}, {7.4, 4.6}, {7.4, 13.4}, {1, 12}}));
      painter.drawPolygon(QPolygonF({{15, 3.2}, {8.6, 4.6}, {8.6, 13.4}, {15, 12}}));
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
