#include "widgets/ViewWidget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorObserver.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>

#include "pellucida/visualization_vtk/View.h"

namespace pellucida {

ViewWidget::ViewWidget(View& view, int samples, QWidget* parent) : QVTKOpenGLNativeWidget(parent), view_(view) {
  window_->SetMultiSamples(samples);
  setRenderWindow(window_.Get());
  view.add_to(window_, {}, devicePixelRatioF());
  setMinimumSize(240, 120);
  set_style(nullptr);
}

ViewWidget::~ViewWidget() = default;

void ViewWidget::set_style(vtkInteractorObserver* style) {
  window_->GetInteractor()->SetInteractorStyle(style);
}

void ViewWidget::render() {
  if (isVisible() && isValid()) window_->Render();
}

bool ViewWidget::event(QEvent* event) {
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  return key ? QOpenGLWidget::event(event) : QVTKOpenGLNativeWidget::event(event);
}

}  // namespace pellucida
