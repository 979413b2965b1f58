#pragma once
#include "widgets/Panel.h"

namespace pellucida {

class FeedView;
class ViewWidget;

/// The microscope's picture with the buttons that say what is drawn over it and how much of it is seen.
class FeedPanel : public Panel {
 public:
  /// `feed` must outlive the panel.
  FeedPanel(FeedView& feed, QWidget* parent);
  ViewWidget& view() noexcept { return *view_; }

 private:
  FeedPanel(FeedView& feed, ViewWidget* view, QWidget* parent);
  void add_buttons(FeedView& feed);

  ViewWidget* view_;
};

}  // namespace pellucida
