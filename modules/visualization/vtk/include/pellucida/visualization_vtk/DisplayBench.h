#pragma once
#include <span>

#include "pellucida/core_vtk/Scene.h"

namespace pellucida {

/// How many scenes a second the three views of the window draw together, off screen, each scene once. Needs an X
/// server, its own (VirtualDisplay) where there is none. Main thread only. 0 for no scenes. Throws DeviceError when
/// there is no way to draw.
double measure_display_frames_per_s(std::span<const Scene> scenes);

}  // namespace pellucida
