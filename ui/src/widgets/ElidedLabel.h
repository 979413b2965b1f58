#pragma once
#include <QLabel>

namespace pellucida {

/// One line of plain text, right-aligned, that leaves out its middle or its end, with an ellipsis, where there is no
/// room for all of it. It never widens its window.
class ElidedLabel : public QLabel {
 public:
  ElidedLabel(Qt::TextElideMode mode, QWidget* parent);
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Qt::TextElideMode mode_;
};

}  // namespace pellucida
