#pragma once
#include <QFrame>

class QHBoxLayout;
class QLabel;

namespace pellucida {

struct StatusTexts;

/// The figures that matter, large: state, indentation, force with its interval, pressure, confidence.
class ReadoutBar : public QFrame {
 public:
  explicit ReadoutBar(QWidget* parent);
  void show_texts(const StatusTexts& texts);

 private:
  struct Figure {
    QLabel* value = nullptr;
    QLabel* note = nullptr;
  };
  Figure add_figure(QHBoxLayout* row, const char* name, const char* widest, const char* widest_note = nullptr);

  QLabel* state_;
  Figure indentation_;
  Figure force_;
  Figure pressure_;
  Figure confidence_;
};

}  // namespace pellucida
