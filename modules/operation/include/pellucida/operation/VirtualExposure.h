#pragma once
#include <memory>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// `source`, a virtual microscope, behind a camera whose exposure can be set: 2 to 30 ms, 10 ms at the start, which
/// leaves its images as they are. Grey values go with the time and end at white; what is white stays so.
std::unique_ptr<FrameSource> with_virtual_exposure(std::unique_ptr<FrameSource> source);

}  // namespace pellucida
