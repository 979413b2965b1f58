#pragma once
#include <QToolButton>
#include <functional>

class QGridLayout;

namespace pellucida {

class MembraneView;

/// The button "Arrows" with what may be chosen about them: which force they show, each with a sentence that explains
/// it; shown at all, with their intervals, how many, how long, from which force on, lengths by the logarithm. Calls
/// `changed` after each change. Keys: 6 arrows on and off, 7 the next force.
class ArrowMenu : public QToolButton {
 public:
  ArrowMenu(MembraneView& view, std::function<void()> changed, QWidget* parent);

 private:
  void add_kinds(QGridLayout* grid);
  void add_looks(QGridLayout* grid);
  void show_kind();

  MembraneView& view_;
  std::function<void()> changed_;
};

}  // namespace pellucida
