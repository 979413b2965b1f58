#pragma once
#include <QFrame>

#include "widgets/Figure.h"

namespace pellucida {

struct TeachTexts;

/// The figures of a poked cell, large.
class TeachReadouts : public QFrame {
 public:
  explicit TeachReadouts(QWidget* parent);
  void show_texts(const TeachTexts& texts);

 private:
  QLabel* state_;
  Figure depth_, force_, volume_, energy_, speed_, rate_;
};

}  // namespace pellucida
