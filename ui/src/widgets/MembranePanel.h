#pragma once
#include "widgets/Panel.h"

namespace pellucida {

class MembraneView;
class ViewWidget;

/// The membranes and forces in 3-D, with what may be chosen about them.
class MembranePanel : public Panel {
 public:
  /// `membranes` must outlive the panel.
  MembranePanel(MembraneView& membranes, QWidget* parent);
  ViewWidget& view() noexcept { return *view_; }

 private:
  MembranePanel(MembraneView& membranes, ViewWidget* view, QWidget* parent);
  void add_coloring_menu(MembraneView& membranes);

  ViewWidget* view_;
};

}  // namespace pellucida
