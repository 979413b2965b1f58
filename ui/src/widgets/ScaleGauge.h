#pragma once
#include <QWidget>

#include "presenters/ScalePresenter.h"

namespace pellucida {

/// The scale as a bar from a quarter to four times the kind's stiffness, logarithmic: the kind's spread in grey, this
/// cell's in the accent's colour once it was measured, one standard deviation either way.
class ScaleGauge : public QWidget {
 public:
  explicit ScaleGauge(QWidget* parent);
  void show_scale(const ScaleTexts& texts);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ScaleTexts texts_;
};

}  // namespace pellucida
