#include "AxesTriad.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <array>

#include "pellucida/visualization_vtk/HudCanvas.h"

namespace pellucida {

void draw_axes_triad(HudCanvas& hud, vtkCamera* camera) {
  constexpr double kLength = 26.0;
  constexpr double kX = 44.0;
  constexpr double kY = 46.0;
  struct Axis {
    double direction[4];
    const char* name;
    Color color;
  };
  const bool is_light = current_theme().is_light;
  std::array<Axis, 3> axes = {{{{1.0, 0.0, 0.0, 0.0}, "x", Color::from_hex(is_light ? 0xB3261E : 0xFF8A80)},
                               {{0.0, 1.0, 0.0, 0.0}, "y", Color::from_hex(is_light ? 0x1E6B2E : 0x9BE58F)},
                               {{0.0, 0.0, 1.0, 0.0}, "z", Color::from_hex(is_light ? 0x2F45C8 : 0x8AB8FF)}}};
  vtkMatrix4x4* to_camera = camera->GetViewTransformMatrix();
  for (Axis& axis : axes) to_camera->MultiplyPoint(axis.direction, axis.direction);
  // The axis that points away from the eye is drawn first.
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.direction[2] < b.direction[2]; });
  for (const Axis& axis : axes) {
    const double x = kX + kLength * axis.direction[0];
    const double y = kY + kLength * axis.direction[1];
    hud.line(kX, kY, x, y, 2.0, axis.color);
    hud.text(kX + (kLength + 10.0) * axis.direction[0], kY + (kLength + 10.0) * axis.direction[1], axis.name,
             {.color = axis.color, .align = HudAlign::kCentre});
  }
}

}  // namespace pellucida
