#pragma once
#include <memory>
#include <string>

#include "pellucida/acquisition/OpenSource.h"

namespace pellucida {

/// A Video4Linux camera by its number: `/dev/videoN`. Frames are stamped when they arrive, on the monotonic clock.
/// `next()` throws DeviceError when the camera stops giving frames.
/// Errors: UsageError when `number` is no number, DeviceError when the camera isn't there or may not be opened, then
/// the options' UsageError.
std::unique_ptr<FrameSource> open_camera(const std::string& number, const std::string& name,
                                         const SourceOptions& options);

}  // namespace pellucida
