#pragma once
#include <vtkNew.h>

#include <QImage>
#include <QWidget>
#include <memory>
#include <vector>

class QVTKInteractor;
class QVTKInteractorAdapter;
class vtkInteractorObserver;
class vtkRenderWindowInteractor;

namespace pellucida {

class View;
class ViewCanvas;

/// Shows one view of the visualization module in the window. The view is rendered beside the screen, one view an event
/// of the window's thread, and painted as a picture: nothing else of the window is drawn again with it. Keys are the
/// window's: VTK's own do nothing.
class ViewWidget : public QWidget {
 public:
  /// `view` must outlive the widget. `samples`: multisampling, 0 for views smoothed by FXAA.
  ViewWidget(View& view, int samples, QWidget* parent);
  ~ViewWidget() override;

  /// All in a window.
  static std::vector<ViewWidget*> all_in(const QWidget& window);

  View& view() noexcept { return view_; }
  /// Of the mouse's gestures.
  vtkRenderWindowInteractor* interactor() const;
  /// What the mouse does; nullptr for nothing.
  void set_style(vtkInteractorObserver* style);
  /// All letters and lines of the view `scale` times as large as the screen's own scaling makes them.
  void set_type_scale(double scale);

  /// Has the view rendered in an event of its own, soon; several calls until then are one. Does nothing while the
  /// widget can't be seen: what appears is rendered then.
  void render();
  /// True from `render` on until it was done.
  bool is_waiting() const noexcept { return waits_; }
  /// The view as it is now, in the screen's pixels.
  QImage picture();
  /// The same, rendered anew with `size_px` pixels: letters and lines as large, over the whole, as on screen.
  QImage picture(QSize size_px);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  friend class ViewTurns;
  void render_now();
  void follow_screen();
  QSize size_in_pixels() const;

  View& view_;
  double type_scale_ = 1.0;
  std::unique_ptr<ViewCanvas> canvas_;
  vtkNew<QVTKInteractor> interactor_;
  std::unique_ptr<QVTKInteractorAdapter> gestures_;
  QImage picture_;
  bool waits_ = false;
};

}  // namespace pellucida
