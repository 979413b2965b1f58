#include "widgets/ViewWidget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorObserver.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>

#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

ViewWidget::ViewWidget(View& view, int samples, QWidget* parent) : QVTKOpenGLNativeWidget(parent), view_(view) {
  window_->SetMultiSamples(samples);
  // The view scales letters and boxes alike; VTK would scale the letters once more.
  setEnableHiDPI(false);
  setRenderWindow(window_.Get());
  view.add_to(window_, {}, devicePixelRatioF());
  setMinimumSize(240, 120);
  set_style(nullptr);
}

ViewWidget::~ViewWidget() = default;

void ViewWidget::set_style(vtkInteractorObserver* style) {
  window_->GetInteractor()->SetInteractorStyle(style);
}

void ViewWidget::set_type_scale(double scale) {
  type_scale_ = scale;
  follow_screen();
}

void ViewWidget::follow_screen() {
  view_.set_hud_ratio(type_scale_ * devicePixelRatioF());
}

void ViewWidget::render() {
  if (isVisible() && isValid()) window_->Render();
}

void ViewWidget::changeEvent(QEvent* event) {
  QVTKOpenGLNativeWidget::changeEvent(event);
  if (event->type() != QEvent::StyleChange) return;
  view_.follow_theme();
  render();
}

bool ViewWidget::event(QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::ScreenChangeInternal) follow_screen();
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  return key ? QOpenGLWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
}

}  // namespace pellucida
