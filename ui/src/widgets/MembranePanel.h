#pragma once
#include "widgets/Panel.h"

namespace pellucida {

class MembraneView;
class ViewWidget;

/// The membranes and forces in 3-D, with what may be chosen about them.
class MembranePanel : public Panel {
 public:
  /// `membranes` must outlive the panel. `has_model`: its scenes hold the mechanical model, which can be shown too.
  MembranePanel(MembraneView& membranes, QWidget* parent, bool has_model = true);
  ViewWidget& view() noexcept { return *view_; }

 private:
  MembranePanel(MembraneView& membranes, ViewWidget* view, QWidget* parent, bool has_model);
  void add_surface_menu(MembraneView& membranes, bool has_model);

  ViewWidget* view_;
};

}  // namespace pellucida
