#pragma once
#include <QDialog>
#include <functional>
#include <string>

#include "BackgroundTask.h"
#include "presenters/PixelMeasure.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace pellucida {

class RulerCanvas;

/// Measures a pixel's edge on an image of the source: a line along a scale bar, or across a needle whose diameter is
/// known, and its length in um. Blocks nothing but its window; deletes itself when it is closed.
class PixelSizeDialog : public QDialog {
 public:
  /// `source`: as `open_source` takes it, read on a thread of its own; `use`: the measure that the person accepts.
  PixelSizeDialog(std::string source, std::function<void(const PixelMeasure&)> use, QWidget* parent);

 private:
  void load(const std::string& source);
  void show_measure();

  std::function<void(const PixelMeasure&)> use_;
  RulerCanvas* ruler_;
  QLineEdit* length_;
  QLabel* result_;
  QPushButton* accept_;
  BackgroundTask loading_;
};

}  // namespace pellucida
