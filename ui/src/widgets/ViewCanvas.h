#pragma once
#include <vtkNew.h>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSize>

class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;
class vtkUnsignedCharArray;

namespace pellucida {

/// Renders into memory, in an OpenGL context of its own. On the window's thread.
class ViewCanvas {
 public:
  /// `samples`: multisampling.
  explicit ViewCanvas(int samples);
  ~ViewCanvas();
  ViewCanvas(const ViewCanvas&) = delete;
  ViewCanvas& operator=(const ViewCanvas&) = delete;

  vtkGenericOpenGLRenderWindow* window() noexcept { return window_; }
  /// What is in the window, rendered with this many pixels; a null picture where the computer has no OpenGL 3.2.
  QImage render(QSize size_px);

 private:
  static void on_event(vtkObject* caller, unsigned long event, void* self, void* data);
  bool begin();

  QOffscreenSurface surface_;
  QOpenGLContext context_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkCallbackCommand> events_;
  vtkNew<vtkUnsignedCharArray> pixels_;
  bool has_begun_ = false, works_ = false;
};

}  // namespace pellucida
