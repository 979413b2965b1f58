#pragma once
#include <QPixmap>
#include <QWidget>
#include <functional>

#include "presenters/TimelinePresenter.h"

class QPainter;

namespace pellucida {

/// The session's time from left to right: the state of the cell as colour, holes where nothing was recorded, hatching
/// where nothing was measured, events as marks above and doubts as an amber line below. Press or drag seeks; the mouse
/// resting on a place describes what is there.
class TimelineBar : public QWidget {
 public:
  /// `seek` is called with a time of the session, s.
  TimelineBar(std::function<void(double)> seek, QWidget* parent);

  void set_timeline(Timeline timeline);
  const Timeline& timeline() const noexcept { return timeline_; }
  /// Time that the cursor marks.
  void set_position_s(double time_s);
  double position_s() const noexcept { return position_s_; }

  /// Where a time is, logical pixels from the left, and back.
  double x_of(double time_s) const;
  double time_at(double x_px) const;
  /// The bar itself, in the widget's coordinates: where a press is meant for.
  QRectF bar() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void draw_ground();
  void draw_legend(QPainter& painter) const;
  void draw_spans(QPainter& painter) const;
  void draw_events(QPainter& painter) const;
  void draw_ticks(QPainter& painter) const;
  void draw_cursor(QPainter& painter) const;

  std::function<void(double)> seek_;
  Timeline timeline_;
  QPixmap ground_;  // all but the cursor; null: to be drawn anew
  double position_s_ = 0.0;
};

}  // namespace pellucida
