#pragma once
#include <QFrame>
#include <vector>

#include "presenters/Phrase.h"
#include "widgets/Figure.h"

namespace pellucida {

/// The figures of a page, large, after a pill that says its state. Where there is no room for all, the least important
/// ones go.
class FigureBar : public QFrame {
 public:
  struct Entry {
    const char* name;  ///< object name of the value
    QString heading, widest, widest_note;
    bool is_essential = false;  ///< stays; of the others, the last ones go first
  };
  FigureBar(const QString& widest_state, std::vector<Entry> entries, QWidget* parent);

  /// The state's colour is the pill's.
  void show_state(const Phrase& state);
  /// Figures in their order; as many as there are entries.
  void show_figures(const std::vector<Phrase>& figures);
  void show_note(std::size_t figure, const Phrase& note);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_what_fits();

  QLabel* state_;
  std::vector<Entry> entries_;
  std::vector<Figure> figures_;
};

}  // namespace pellucida
