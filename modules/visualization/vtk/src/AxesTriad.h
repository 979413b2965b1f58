#pragma once

class vtkCamera;

namespace pellucida {

class HudCanvas;

/// A small triad x, y, z in the lower left corner that turns with `camera`.
void draw_axes_triad(HudCanvas& hud, vtkCamera* camera);

}  // namespace pellucida
