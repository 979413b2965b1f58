#pragma once
#include <QComboBox>

namespace pellucida {

/// A choice with the same arrow as the window's other menus. The wheel does not change it.
class Choice final : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace pellucida
