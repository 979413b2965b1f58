#pragma once
#include "widgets/Panel.h"

class QMenu;

namespace pellucida {

class FeedView;
class ViewWidget;

/// The microscope's picture with the buttons that say what is drawn over it and how much of it is seen.
class FeedPanel : public Panel {
 public:
  /// `feed` must outlive the panel. `has_model`: its scenes hold the mechanical model, and there is a button for it.
  FeedPanel(FeedView& feed, QWidget* parent, bool has_model = true);
  ViewWidget& view() noexcept { return *view_; }
  /// How the image is shown; whoever knows the camera adds to it.
  QMenu& image_menu() noexcept { return *image_menu_; }

 private:
  FeedPanel(FeedView& feed, ViewWidget* view, QWidget* parent, bool has_model);
  void add_buttons(FeedView& feed, bool has_model);

  ViewWidget* view_;
  QMenu* image_menu_ = nullptr;
};

}  // namespace pellucida
