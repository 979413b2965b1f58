#pragma once
#include <string>

#include "PhysicalSize.h"
#include "pellucida/acquisition/OpenSource.h"
#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// Throws UsageError, with value and range, for an option that is no sensible number.
void check_options(const SourceOptions& options);

/// Sets the pixel size of `info` and its origin: the option, else what the file says.
/// Throws UsageError when neither is there; the text names the option.
void settle_pixel_size(SourceInfo& info, const SourceOptions& options, const PhysicalSize& metadata);

/// Sets the frame rate of `info` and its origin likewise.
void settle_frame_rate(SourceInfo& info, const SourceOptions& options, const PhysicalSize& metadata);

}  // namespace pellucida
