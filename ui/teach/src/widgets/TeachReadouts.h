#pragma once
#include <QFrame>

#include "widgets/Figure.h"

namespace pellucida {

struct TeachTexts;

/// The figures of a poked cell, large. Where there is no room for all, the least important ones go.
class TeachReadouts : public QFrame {
 public:
  explicit TeachReadouts(QWidget* parent);
  void show_texts(const TeachTexts& texts);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_what_fits();

  QLabel* state_;
  Figure depth_, force_, volume_, energy_, speed_, rate_;
};

}  // namespace pellucida
