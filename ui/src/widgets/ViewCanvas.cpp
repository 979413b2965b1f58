#include "widgets/ViewCanvas.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkUnsignedCharArray.h>

#include <QVTKOpenGLNativeWidget.h>
#include <cstring>

namespace pellucida {

ViewCanvas::ViewCanvas(int samples) {
  window_->SetMultiSamples(samples);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetForceMaximumHardwareLineWidth(1.0F);
  events_->SetClientData(this);
  events_->SetCallback(&ViewCanvas::on_event);
  for (const unsigned long event : {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
                                    vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent}) {
    window_->AddObserver(event, events_);
  }
}

ViewCanvas::~ViewCanvas() {
  if (works_ && context_.makeCurrent(&surface_)) window_->Finalize();
  window_->RemoveObserver(events_);
  context_.doneCurrent();
}

bool ViewCanvas::begin() {
  if (has_begun_) return works_;
  has_begun_ = true;
  const QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  context_.setFormat(format);
  if (!context_.create()) return false;
  surface_.setFormat(context_.format());
  surface_.create();
  if (!context_.makeCurrent(&surface_)) return false;
  window_->SetOwnContext(0);
  window_->SetReadyForRendering(true);
  window_->OpenGLInit();
  return works_ = true;
}

QImage ViewCanvas::render(QSize size_px) {
  if (size_px.isEmpty() || !begin() || !context_.makeCurrent(&surface_)) return {};
  const int width_px = size_px.width(), height_px = size_px.height();
  window_->SetSize(width_px, height_px);
  // A context begins with less, under which of two flat things the second would be lost.
  window_->GetState()->Reset();
  window_->GetState()->vtkglDepthFunc(GL_LEQUAL);
  window_->Render();
  // What was resolved and smoothed.
  constexpr int kFront = 1;
  window_->GetRGBACharPixelData(0, 0, width_px - 1, height_px - 1, kFront, pixels_);
  if (pixels_->GetNumberOfTuples() != static_cast<vtkIdType>(width_px) * height_px) return {};
  // OpenGL's first row is the lowest. Opaque, whatever was blended.
  QImage picture(size_px, QImage::Format_RGBX8888);
  const std::size_t row_bytes = 4 * static_cast<std::size_t>(width_px);
  const unsigned char* from = pixels_->GetPointer(0);
  for (int row = height_px - 1; row >= 0; --row, from += row_bytes) {
    std::memcpy(picture.scanLine(row), from, row_bytes);
  }
  return picture;
}

void ViewCanvas::on_event(vtkObject*, unsigned long event, void* self, void* data) {
  auto* canvas = static_cast<ViewCanvas*>(self);
  switch (event) {
    case vtkCommand::WindowMakeCurrentEvent:
      if (QOpenGLContext::currentContext() != &canvas->context_) canvas->context_.makeCurrent(&canvas->surface_);
      break;
    case vtkCommand::WindowIsCurrentEvent:
      *static_cast<bool*>(data) = QOpenGLContext::currentContext() == &canvas->context_;
      break;
    case vtkCommand::WindowSupportsOpenGLEvent:
    case vtkCommand::WindowIsDirectEvent:
      *static_cast<int*>(data) = 1;
      break;
    default:
      break;
  }
}

}  // namespace pellucida
