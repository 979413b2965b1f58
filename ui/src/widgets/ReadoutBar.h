#pragma once
#include <QFrame>

#include "widgets/Figure.h"

class QLabel;
class QVBoxLayout;

namespace pellucida {

class ScaleGauge;
class StatePill;
struct ReadoutTexts;
struct ScaleTexts;

/// The figures that matter, large: state, indentation, force with its interval, pressure, confidence;
/// the scale, and the cell profile they rest on.
class ReadoutBar : public QFrame {
 public:
  explicit ReadoutBar(QWidget* parent);
  void show_texts(const ReadoutTexts& texts);
  void show_scale(const ScaleTexts& texts);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QVBoxLayout* build_scale();

  StatePill* state_;
  Figure indentation_;
  Figure force_;
  Figure pressure_;
  Figure confidence_;
  FigureLabel* scale_;
  ScaleGauge* gauge_;
  Figure profile_;
};

}  // namespace pellucida
