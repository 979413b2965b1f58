#pragma once
#include <functional>
#include <optional>
#include <span>

#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// Draws the three views of the window off screen, scene by scene, until `next` gives none; how many a second, without
/// the first. Needs an X server, its own (VirtualDisplay) where there is none. Main thread only. 0 for less than two
/// scenes. Throws DeviceError when there is no way to draw.
double draw_scenes(const std::function<std::optional<Scene>()>& next);

/// How many scenes a second the three views of the window draw together, off screen, each scene once. As `draw_scenes`.
double measure_display_frames_per_s(std::span<const Scene> scenes);

}  // namespace pellucida
