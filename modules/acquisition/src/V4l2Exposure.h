#pragma once
#include <functional>
#include <memory>
#include <string>

#include "pellucida/core/CameraExposure.h"

namespace pellucida {

/// A request to a Video4Linux driver, as `ioctl`: 0, or -1 with `errno`.
using V4l2Port = std::function<int(unsigned long request, void* argument)>;

/// The exposure of the camera behind `port`; nullptr where its driver has none that can be set (in absolute time).
/// `name`: for errors. `frame_rate_hz`: no exposure longer than a period is offered, since frames would be lost.
std::shared_ptr<CameraExposure> find_v4l2_exposure(V4l2Port port, std::string name, double frame_rate_hz);

/// The same of a device such as `/dev/video0`, which may be in use by others meanwhile.
std::shared_ptr<CameraExposure> open_v4l2_exposure(const std::string& device, std::string name, double frame_rate_hz);

}  // namespace pellucida
