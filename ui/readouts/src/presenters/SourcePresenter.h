#pragma once
#include <string>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// The source's name as it fits into a line: a file without its folder.
std::string source_label(const SourceInfo& info);

/// "Pellucida - virtual:default": the window's title.
std::string window_title(const SourceInfo& info);

/// "728 × 486 px · 0.825 µm/px · 30 frames/s": what the picture is, in one line.
std::string source_caption(const SourceInfo& info);

}  // namespace pellucida
