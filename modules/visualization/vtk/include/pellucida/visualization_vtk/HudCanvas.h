#pragma once
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <string>
#include <vector>

#include "pellucida/visualization/Palette.h"

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkTextActor;
class vtkUnsignedCharArray;

namespace pellucida {

enum class HudAlign { kLeft, kCentre, kRight };

/// How a text is set.
struct HudText {
  int size_pt = font_size::kSmall;
  Color color = current_theme().text;
  bool bold = false;
  HudAlign align = HudAlign::kLeft;
};

/// Flat shapes and texts over a renderer, redrawn each frame in an immediate style: `begin`, shapes, `end`. Coordinates
/// and lengths are logical pixels of the renderer's viewport, origin at the bottom left; `ratio` (device pixels a
/// logical one) scales everything, so that a picture of twice the dots looks the same. Shapes keep their order; texts
/// lie on top.
class HudCanvas {
 public:
  explicit HudCanvas(vtkRenderer* renderer);
  ~HudCanvas();
  HudCanvas(const HudCanvas&) = delete;
  HudCanvas& operator=(const HudCanvas&) = delete;

  void begin(double ratio);
  void rectangle(double x, double y, double width_px, double height_px, const Color& color, double opacity = 1.0);
  /// A rectangle with corners of radius `radius_px`, at most half the smaller side.
  void rounded(double x, double y, double width_px, double height_px, double radius_px, const Color& color,
               double opacity = 1.0);
  void line(double x0, double y0, double x1, double y1, double width_px, const Color& color, double opacity = 1.0);
  void disc(double x, double y, double radius_px, const Color& color, double opacity = 1.0);
  /// A text whose middle line is at `y`.
  void text(double x, double y, const std::string& utf8, const HudText& style = {});
  void end();

  /// Width of a text.
  double text_width_px(const std::string& utf8, const HudText& style = {});

 private:
  // `clear_corners`: a bit for each corner that is drawn without opacity.
  void polygon(const std::vector<double>& xy, const Color& color, double opacity, unsigned clear_corners = 0);
  vtkTextActor* next_text();

  vtkRenderer* renderer_;
  double ratio_ = 1.0;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> shapes_;
  vtkNew<vtkActor2D> actor_;
  std::vector<vtkSmartPointer<vtkTextActor>> texts_;
  std::size_t text_count_ = 0;
};

}  // namespace pellucida
