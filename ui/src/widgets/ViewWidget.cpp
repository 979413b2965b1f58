#include "widgets/ViewWidget.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkInteractorObserver.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWindowToImageFilter.h>

#include <QEvent>
#include <algorithm>

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

QImage ViewWidget::picture(QSize size_px) {
  const QSizeF shown = QSizeF(size()) * devicePixelRatioF();
  if (!isValid() || size_px.isEmpty() || shown.isEmpty()) return grabFramebuffer();
  const double scale = std::min(size_px.width() / shown.width(), size_px.height() / shown.height());
  const int before[2] = {window_->GetSize()[0], window_->GetSize()[1]};
  makeCurrent();
  view_.set_hud_ratio(type_scale_ * devicePixelRatioF() * scale);
  window_->SetSize(size_px.width(), size_px.height());
  window_->Render();
  vtkNew<vtkWindowToImageFilter> grabbed;
  grabbed->SetInput(window_);
  grabbed->SetInputBufferTypeToRGB();
  grabbed->ReadFrontBufferOff();
  grabbed->ShouldRerenderOff();
  grabbed->Update();
  vtkImageData* pixels = grabbed->GetOutput();
  const int* dimensions = pixels->GetDimensions();
  const QImage bottom_up(static_cast<const uchar*>(pixels->GetScalarPointer()), dimensions[0], dimensions[1],
                         3 * dimensions[0], QImage::Format_RGB888);
  QImage result = bottom_up.mirrored(false, true);
  window_->SetSize(before[0], before[1]);
  follow_screen();
  render();
  return result;
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
