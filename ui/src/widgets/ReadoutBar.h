#pragma once
#include <QFrame>

#include "widgets/Figure.h"

class QLabel;

namespace pellucida {

struct ReadoutTexts;

/// The figures that matter, large: state, indentation, force with its interval, pressure, confidence;
/// and the cell profile they rest on.
class ReadoutBar : public QFrame {
 public:
  explicit ReadoutBar(QWidget* parent);
  void show_texts(const ReadoutTexts& texts);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* state_;
  Figure indentation_;
  Figure force_;
  Figure pressure_;
  Figure confidence_;
  Figure profile_;
};

}  // namespace pellucida
