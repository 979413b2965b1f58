#pragma once
#include <filesystem>
#include <span>

#include "pellucida/core/Measurement.h"
#include "pellucida/core_vtk/Scene.h"

class vtkRenderWindow;

namespace pellucida {

/// Size of a picture in dots.
struct PictureSize {
  int width_px = 1600;
  int height_px = 1100;
};

/// One picture of a run, drawn off screen: a line of figures on top, the frame with what was found in it on the left,
/// the membranes with the forces in 3-D on the right, the force-indentation and the force-time curve of `rows` below.
/// Written as PNG, whole or not at all. Needs an X server; starts its own (VirtualDisplay) if there is none. Main
/// thread only. Throws DeviceError when drawing is impossible, OutputError when the file can't be written, UsageError
/// for a size below 400 x 300 or above 8000 x 8000.
void render_picture(const Scene& scene, std::span<const Measurement> rows, const std::filesystem::path& png,
                    const PictureSize& size = {});

/// Throws UsageError for a size below 400 x 300 or above 8000 x 8000.
void check_picture_size(const PictureSize& size);

/// A window's present contents as a PNG, completely or not at all. Throws OutputError.
void save_window(vtkRenderWindow* window, const std::filesystem::path& png);

}  // namespace pellucida
