#pragma once
#include <optional>

class vtkPolyData;
class vtkRenderer;

namespace pellucida {

/// The surface's node nearest to the place where the line of sight through a point of the viewport (device pixels,
/// origin at the bottom left) enters it; nothing where it misses the surface.
std::optional<long> pick_node(vtkRenderer* renderer, double x_px, double y_px, vtkPolyData* surface);

}  // namespace pellucida
