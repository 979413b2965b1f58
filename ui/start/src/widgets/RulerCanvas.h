#pragma once
#include <QImage>
#include <QPointF>
#include <QWidget>
#include <functional>

#include "presenters/PixelMeasure.h"

namespace pellucida {

/// An image with a line on it that a person draws: by dragging, an end at a time, or with the arrow keys, which move
/// the end touched last by a pixel (with Shift by ten; Space goes to the other end). The wheel zooms at the pointer.
class RulerCanvas : public QWidget {
 public:
  explicit RulerCanvas(std::function<void()> changed, QWidget* parent = nullptr);

  /// Shows another image, its line across the middle.
  void set_image(const QImage& image);
  bool has_image() const noexcept { return !image_.isNull(); }
  const DrawnLine& line() const noexcept { return line_; }
  /// Where a place of the image is in the widget.
  QPointF to_widget(double x_px, double y_px) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double scale() const;
  QPointF to_image(const QPointF& place) const;
  void move_end(const QPointF& place_px);

  std::function<void()> changed_;
  QImage image_;
  DrawnLine line_;
  bool second_end_ = true;  // the one touched last
  double zoom_ = 1.0;
  QPointF middle_px_;  // of the image, in the widget's middle
};

}  // namespace pellucida
