#pragma once
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <utility>

#include "pellucida/visualization_vtk/HudCanvas.h"

class vtkCallbackCommand;
class vtkObject;
class vtkRenderWindow;
class vtkRenderer;

namespace pellucida {

/// A part of a window, in fractions of its size, origin at the bottom left.
struct Viewport {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 1.0;
  double y1 = 1.0;
};

/// The base of every view: a renderer for the scene (FXAA, unless the window is multisampled) and one above it for
/// legends, scales and texts, laid out at each rendering so that any window size works. Use on the thread that renders.
class View {
 public:
  View();
  virtual ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Puts both renderers into `window`, whose multisampling is set before. `hud_ratio` scales letters and lines (2 for
  /// a picture of twice the dots).
  void add_to(vtkRenderWindow* window, const Viewport& viewport = {}, double hud_ratio = 1.0);

  /// Scales letters and lines from the next rendering on, > 0.
  void set_hud_ratio(double hud_ratio) noexcept { hud_ratio_ = hud_ratio; }

  /// Takes the colours of `current_theme()`, from the next rendering on.
  virtual void follow_theme();

  vtkRenderer* renderer() const noexcept;

 protected:
  /// Called before the scene is rendered: camera and sizes in device pixels.
  virtual void prepare(double /*width_px*/, double /*height_px*/) {}
  /// Draws legends and texts; sizes in logical pixels.
  virtual void draw_hud(HudCanvas& /*hud*/, double /*width_px*/, double /*height_px*/) {}
  /// Where a point of the scene lies in the viewport, in logical pixels; {x, y}.
  std::pair<double, double> to_hud(const double world_um[3]) const;
  double hud_ratio() const noexcept { return hud_ratio_; }

  vtkSmartPointer<vtkRenderer> main_;

 private:
  static void on_start(vtkObject* caller, unsigned long event, void* self, void* data);

  vtkNew<vtkRenderer> over_;
  vtkNew<vtkCallbackCommand> starts_;
  std::unique_ptr<HudCanvas> hud_;
  double hud_ratio_ = 1.0;
};

}  // namespace pellucida
