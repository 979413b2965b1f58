#include "widgets/FeedPanel.h"

#include <QToolButton>

#include "Words.h"
#include "pellucida/visualization_vtk/FeedView.h"
#include "pellucida/visualization_vtk/PanZoomStyle.h"
#include "widgets/ImageMenu.h"
#include "widgets/KeySheet.h"
#include "widgets/ViewWidget.h"

namespace pellucida {

FeedPanel::FeedPanel(FeedView& feed, QWidget* parent, bool has_model)
    : FeedPanel(feed, new ViewWidget(feed, 0, nullptr), parent, has_model) {}

FeedPanel::FeedPanel(FeedView& feed, ViewWidget* view, QWidget* parent, bool has_model)
    : Panel(words("Microscope"), view, parent), view_(view) {
  vtkNew<PanZoomStyle> style;
  view_->set_style(style);
  explain_gesture(*view_, words("Drag, wheel"), words("Move the image, zoom"));
  add_buttons(feed, has_model);
}

void FeedPanel::add_buttons(FeedView& feed, bool has_model) {
  const auto toggle = [&](const QString& text, const QString& tip, const QKeySequence& key, bool on, auto change) {
    connect(add_toggle(text, tip, key, on), &QToolButton::toggled, this, [this, &feed, change](bool now) {
      change(feed, now);
      view_->render();
    });
  };
  toggle(words("Contours"), words("Membranes found in the image"), Qt::Key_1, true,
         [](FeedView& view, bool on) { view.show_contours(on); });
  if (has_model) {
    toggle(words("Model"), words("Section through the mechanical model"), Qt::Key_2, true,
           [](FeedView& view, bool on) { view.show_model_section(on); });
  }
  toggle(words("Tools"), words("Needle and holding pipette"), Qt::Key_3, true,
         [](FeedView& view, bool on) { view.show_tools(on); });
  auto* image = new ImageMenu(
      feed, [this] { view_->render(); }, this);
  image_menu_ = image->menu();
  add_control(image);
}

}  // namespace pellucida
