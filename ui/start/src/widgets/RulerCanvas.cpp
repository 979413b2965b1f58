#include "widgets/RulerCanvas.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "Theme.h"
#include "Words.h"
#include "pellucida/visualization/Palette.h"

namespace pellucida {
namespace {

constexpr double kGrasp_px = 14.0;
constexpr double kLargestZoom = 16.0;
constexpr double kZoomStep = 1.25;
constexpr double kEndMark_px = 7.0;

}  // namespace

RulerCanvas::RulerCanvas(std::function<void()> changed, QWidget* parent)
    : QWidget(parent), changed_(std::move(changed)) {
  setObjectName("ruler");
  setMinimumSize(560, 360);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setAccessibleName(words("Image with a line"));
}

void RulerCanvas::set_image(const QImage& image) {
  image_ = image;
  zoom_ = 1.0;
  middle_px_ = QPointF(0.5 * image.width(), 0.5 * image.height());
  line_ = {0.25 * image.width(), middle_px_.y(), 0.75 * image.width(), middle_px_.y()};
  update();
  changed_();
}

double RulerCanvas::scale() const {
  if (image_.isNull()) return 1.0;
  return zoom_ *
         std::min(width() / static_cast<double>(image_.width()), height() / static_cast<double>(image_.height()));
}

QPointF RulerCanvas::to_widget(double x_px, double y_px) const {
  return QPointF(0.5 * width(), 0.5 * height()) + scale() * (QPointF(x_px, y_px) - middle_px_);
}

QPointF RulerCanvas::to_image(const QPointF& place) const {
  return middle_px_ + (place - QPointF(0.5 * width(), 0.5 * height())) / scale();
}

void RulerCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), to_qt(current_theme().window));
  if (image_.isNull()) return;
  // Pixels are what is measured: enlarged ones stay squares.
  painter.setRenderHint(QPainter::SmoothPixmapTransform, scale() < 1.0);
  painter.drawImage(QRectF(to_widget(0, 0), to_widget(image_.width(), image_.height())), image_);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF begin = to_widget(line_.x0_px, line_.y0_px), end = to_widget(line_.x1_px, line_.y1_px);
  const double length = std::max(1.0, std::hypot(end.x() - begin.x(), end.y() - begin.y()));
  const QPointF upright = kEndMark_px / length * QPointF(begin.y() - end.y(), end.x() - begin.x());
  // Dark below, bright above: seen on any image.
  for (const auto& pen : {QPen(QColor(0, 0, 0, 200), 4.0), QPen(to_qt(current_theme().accent), 2.0)}) {
    painter.setPen(pen);
    painter.drawLine(begin, end);
    for (const QPointF& place : {begin, end}) painter.drawLine(place - upright, place + upright);
  }
  if (hasFocus()) painter.drawEllipse(second_end_ ? end : begin, kGrasp_px, kGrasp_px);
}

void RulerCanvas::mousePressEvent(QMouseEvent* event) {
  if (image_.isNull() || event->button() != Qt::LeftButton) return;
  const QPointF place = event->localPos();
  const auto is_at = [&](double x_px, double y_px) {
    const QPointF away = to_widget(x_px, y_px) - place;
    return std::hypot(away.x(), away.y()) <= kGrasp_px;
  };
  if (is_at(line_.x1_px, line_.y1_px)) {
    second_end_ = true;
  } else if (is_at(line_.x0_px, line_.y0_px)) {
    second_end_ = false;
  } else {
    // A new line.
    second_end_ = false;
    move_end(to_image(place));
    second_end_ = true;
  }
  move_end(to_image(place));
}

void RulerCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (image_.isNull() || !(event->buttons() & Qt::LeftButton)) return;
  QPointF place = to_image(event->localPos());
  if (event->modifiers() & Qt::ShiftModifier) {
    // Level or upright.
    const QPointF other = second_end_ ? QPointF(line_.x0_px, line_.y0_px) : QPointF(line_.x1_px, line_.y1_px);
    const QPointF way = place - other;
    place = std::abs(way.x()) >= std::abs(way.y()) ? QPointF(place.x(), other.y()) : QPointF(other.x(), place.y());
  }
  move_end(place);
}

void RulerCanvas::wheelEvent(QWheelEvent* event) {
  if (image_.isNull()) return;
  const QPointF under = to_image(event->position());
  zoom_ = std::clamp(zoom_ * std::pow(kZoomStep, event->angleDelta().y() / 120.0), 1.0, kLargestZoom);
  // What is under the pointer stays there.
  middle_px_ += under - to_image(event->position());
  if (zoom_ == 1.0) middle_px_ = QPointF(0.5 * image_.width(), 0.5 * image_.height());
  event->accept();
  update();
}

void RulerCanvas::keyPressEvent(QKeyEvent* event) {
  const double step_px = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  const QPointF end = second_end_ ? QPointF(line_.x1_px, line_.y1_px) : QPointF(line_.x0_px, line_.y0_px);
  switch (event->key()) {
    case Qt::Key_Left:
      return move_end(end - QPointF(step_px, 0));
    case Qt::Key_Right:
      return move_end(end + QPointF(step_px, 0));
    case Qt::Key_Up:
      return move_end(end - QPointF(0, step_px));
    case Qt::Key_Down:
      return move_end(end + QPointF(0, step_px));
    case Qt::Key_Space:
      second_end_ = !second_end_;
      return update();
    default:
      QWidget::keyPressEvent(event);
  }
}

void RulerCanvas::move_end(const QPointF& place_px) {
  if (image_.isNull()) return;
  const double x_px = std::clamp(place_px.x(), 0.0, static_cast<double>(image_.width()));
  const double y_px = std::clamp(place_px.y(), 0.0, static_cast<double>(image_.height()));
  (second_end_ ? line_.x1_px : line_.x0_px) = x_px;
  (second_end_ ? line_.y1_px : line_.y0_px) = y_px;
  update();
  changed_();
}

}  // namespace pellucida
