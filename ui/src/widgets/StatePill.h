#pragma once
#include <QLabel>

namespace pellucida {

struct Phrase;

/// The cell's state in its colour, with room for the longest of the states in the windows' language.
class StatePill : public QLabel {
 public:
  explicit StatePill(QWidget* parent);
  void show_state(const Phrase& state);
};

}  // namespace pellucida
