#pragma once
#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>

#include <QImage>

class vtkGenericOpenGLRenderWindow;
class vtkInteractorObserver;

namespace pellucida {

class View;

/// Shows one view of the visualization module in the window. Keys are the window's: VTK's own do nothing.
class ViewWidget : public QVTKOpenGLNativeWidget {
 public:
  /// `view` must outlive the widget. `samples`: multisampling, 0 for views smoothed by FXAA.
  ViewWidget(View& view, int samples, QWidget* parent);
  ~ViewWidget() override;

  View& view() noexcept { return view_; }
  /// What the mouse does; nullptr for nothing.
  void set_style(vtkInteractorObserver* style);
  /// All letters and lines of the view `scale` times as large as the screen's own scaling makes them.
  void set_type_scale(double scale);
  /// The view as it is, rendered anew with `size_px` pixels: letters and lines as large, over the whole, as on screen.
  QImage picture(QSize size_px);
  /// Renders now; does nothing while the widget can't be seen.
  void render();

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void follow_screen();

  View& view_;
  double type_scale_ = 1.0;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
};

}  // namespace pellucida
