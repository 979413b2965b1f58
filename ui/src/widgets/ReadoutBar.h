#pragma once
#include <QFrame>

class QHBoxLayout;
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
  struct Figure {
    QLabel* value = nullptr;
    QLabel* note = nullptr;
  };
  // `name`: the label's object name, its note's with "Note" after it.
  Figure add_figure(QHBoxLayout* row, const char* name, const char* heading, const char* widest,
                    const char* widest_note = nullptr);

  QLabel* state_;
  Figure indentation_;
  Figure force_;
  Figure pressure_;
  Figure confidence_;
  Figure profile_;
};

}  // namespace pellucida
