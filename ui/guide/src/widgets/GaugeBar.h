#pragma once
#include <QFrame>
#include <array>
#include <span>

#include "presenters/GaugePresenter.h"

class QLabel;

namespace pellucida {

/// One gauge: name and alarm, a large number, its bar with the limit's mark, interval and limit in words. Calm ones are
/// blue on the panel; one that isn't has a frame and a plate in its colour, with a word: never colour alone.
class GaugeBox : public QFrame {
 public:
  explicit GaugeBox(QWidget* parent);
  void show_gauge(const Gauge& gauge);
  const Gauge& gauge() const noexcept { return gauge_; }
  void set_letters(int largest_px);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit_number();

  Gauge gauge_;
  int letters_px_ = 0;
  QLabel* name_;
  QLabel* alarm_;
  QLabel* truth_;
  QLabel* value_;
  QLabel* note_;
  QLabel* limit_;
};

/// The gauges side by side, for a look from two metres.
class GaugeBar : public QFrame {
 public:
  explicit GaugeBar(QWidget* parent);
  /// A low window leaves more of its height to the views.
  void set_low(bool low);
  void show_gauges(const std::array<Gauge, 4>& gauges);
  /// As they are shown.
  const std::array<Gauge, 4>& gauges() const noexcept { return gauges_; }

 private:
  std::array<GaugeBox*, 4> boxes_{};
  std::array<Gauge, 4> gauges_;
};

}  // namespace pellucida
