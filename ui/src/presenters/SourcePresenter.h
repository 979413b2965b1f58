#pragma once
#include <string>

#include "pellucida/acquisition/FrameSource.h"

namespace pellucida {

/// "Pellucida - virtual:default": the window's title.
std::string window_title(const SourceInfo& info);

/// "728 × 486 px · 0.825 µm/px · 30 frames/s": what the picture is, in one line.
std::string source_caption(const SourceInfo& info);

}  // namespace pellucida
