#include "widgets/Icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <algorithm>

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
  painter.setPen(QPen(to_qt(current_theme().text), 1.7));
  painter.drawArc(QRectF(3, 3, 10, 10), 20 * 16, 300 * 16);
  painter.setPen(Qt::NoPen);
  painter.setBrush(to_qt(current_theme().text));
  painter.drawPolygon(QPolygonF({{10.2, 7.0}, {15.4, 7.0}, {12.8, 2.6}}));
}

void mirror(QPainter& painter) {
  painter.translate(kField, 0.0);
  painter.scale(-1.0, 1.0);
}

void draw(QPainter& painter, Pictogram pictogram) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(to_qt(current_theme().text));
  switch (pictogram) {
    case Pictogram::kProgram:
      // A cell in its clear zone, touched from the right; the same in every theme.
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
      painter.setBrush(to_qt(current_theme().record));
      painter.drawEllipse(QPointF(8, 8), 5, 5);
      break;
    case Pictogram::kStop:
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
      painter.setBrush(to_qt(current_theme().raised));
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
    case Pictogram::kCompare:
      // Two pages side by side.
      painter.drawRect(QRectF(1.5, 2.5, 5.5, 11));
      painter.drawRect(QRectF(9, 2.5, 5.5, 11));
      break;
    case Pictogram::kHome:
      painter.drawPolygon(QPolygonF({{8, 1.5},
                                     {15, 8},
                                     {13, 8},
                                     {13, 14},
                                     {9.6, 14},
                                     {9.6, 9.8},
                                     {6.4, 9.8},
                                     {6.4, 14},
                                     {3, 14},
                                     {3, 8},
                                     {1, 8}}));
      break;
    case Pictogram::kNote:
      painter.drawRect(QRectF(3, 3, 10, 1.6));
      painter.drawRect(QRectF(3, 7, 10, 1.6));
      painter.drawRect(QRectF(3, 11, 6, 1.6));
      break;
    case Pictogram::kScale:
      painter.drawRect(QRectF(2, 7.2, 12, 1.6));
      for (const double x : {2.0, 7.2, 12.4}) painter.drawRect(QRectF(x, 4.5, 1.6, 7));
      break;
  }
}

// Drawn when it is shown, in the colours of the theme at that time.
class PictogramEngine : public QIconEngine {
 public:
  explicit PictogramEngine(Pictogram pictogram) : pictogram_(pictogram) {}

  void paint(QPainter* painter, const QRect& place, QIcon::Mode mode, QIcon::State) override {
    const double side = std::min(place.width(), place.height());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setOpacity(mode == QIcon::Disabled ? kFaded : 1.0);
    painter->translate(place.x() + 0.5 * (place.width() - side), place.y() + 0.5 * (place.height() - side));
    painter->scale(side / kField, side / kField);
    draw(*painter, pictogram_);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return pixmap;
  }

  QIconEngine* clone() const override { return new PictogramEngine(pictogram_); }

 private:
  static constexpr double kFaded = 0.45;

  Pictogram pictogram_;
};

}  // namespace

QIcon make_icon(Pictogram pictogram) {
  return QIcon(new PictogramEngine(pictogram));
}

}  // namespace pellucida
