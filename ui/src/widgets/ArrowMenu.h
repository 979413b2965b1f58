#pragma once
#include <QToolButton>
#include <functional>

namespace pellucida {

class MembraneView;

/// The button "Arrows" with what may be chosen about them: shown at all, how many, how long, from which force on,
/// lengths by the logarithm. Calls `changed` after each change.
class ArrowMenu : public QToolButton {
 public:
  ArrowMenu(MembraneView& view, std::function<void()> changed, QWidget* parent);
};

}  // namespace pellucida
