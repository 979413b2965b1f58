#include "V4l2Exposure.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// V4L2_CID_EXPOSURE_ABSOLUTE counts steps of 100 us.
constexpr double kSteps_per_ms = 10.0;

class V4l2Exposure final : public CameraExposure {
 public:
  V4l2Exposure(V4l2Port port, std::string name, const v4l2_queryctrl& range, std::optional<int> automatic, int most)
      : port_(std::move(port)), name_(std::move(name)), range_(range), automatic_(automatic), most_(most) {}

  State state() const override {
    State state;
    state.time_ms = get(V4L2_CID_EXPOSURE_ABSOLUTE) / kSteps_per_ms;
    state.least_ms = range_.minimum / kSteps_per_ms;
    state.most_ms = most_ / kSteps_per_ms;
    state.has_automatic = automatic_.has_value();
    state.automatic = automatic_ && get(V4L2_CID_EXPOSURE_AUTO) != V4L2_EXPOSURE_MANUAL;
    return state;
  }

  void set_time_ms(double time_ms) override {
    if (!std::isfinite(time_ms)) throw UsageError(name_ + ": the exposure time must be a number, ms");
    // Drivers refuse a time while they choose it themselves.
    if (automatic_) set(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL);
    const int step = std::max(1, range_.step);
    const double steps = std::clamp(time_ms * kSteps_per_ms, double(range_.minimum), double(most_));
    const int whole = range_.minimum + step * static_cast<int>(std::lround((steps - range_.minimum) / step));
    set(V4L2_CID_EXPOSURE_ABSOLUTE, std::min(whole, most_));
  }

  void set_automatic() override {
    if (!automatic_) throw UsageError(name_ + ": the camera has no automatic exposure; set a time");
    set(V4L2_CID_EXPOSURE_AUTO, *automatic_);
  }

 private:
  int get(unsigned id) const {
    v4l2_control control{id, 0};
    if (port_(VIDIOC_G_CTRL, &control) != 0) refuse();
    return control.value;
  }

  void set(unsigned id, int value) const {
    v4l2_control control{id, value};
    if (port_(VIDIOC_S_CTRL, &control) != 0) refuse();
  }

  [[noreturn]] void refuse() const {
    throw DeviceError(name_ + ": the camera refuses its exposure control (" + std::generic_category().message(errno) +
                      "); check its cable, and close other programs that control it");
  }

  V4l2Port port_;
  std::string name_;
  v4l2_queryctrl range_;
  std::optional<int> automatic_;  // the value that stands for it
  int most_;
};

std::optional<v4l2_queryctrl> query(const V4l2Port& port, unsigned id) {
  v4l2_queryctrl control{};
  control.id = id;
  if (port(VIDIOC_QUERYCTRL, &control) != 0) return std::nullopt;
  // One that is inactive (while the camera chooses the time) can be used once it is manual.
  if ((control.flags & (V4L2_CTRL_FLAG_DISABLED | V4L2_CTRL_FLAG_READ_ONLY)) != 0U) return std::nullopt;
  return control;
}

// Cameras call it by one of two names: all automatic, or the time alone beside a fixed aperture.
std::optional<int> find_automatic(const V4l2Port& port) {
  if (!query(port, V4L2_CID_EXPOSURE_AUTO)) return std::nullopt;
  for (const int value : {V4L2_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY}) {
    v4l2_querymenu entry{};
    entry.id = V4L2_CID_EXPOSURE_AUTO;
    entry.index = static_cast<unsigned>(value);
    if (port(VIDIOC_QUERYMENU, &entry) == 0) return value;
  }
  return std::nullopt;
}

}  // namespace

std::shared_ptr<CameraExposure> find_v4l2_exposure(V4l2Port port, std::string name, double frame_rate_hz) {
  auto range = query(port, V4L2_CID_EXPOSURE_ABSOLUTE);
  if (!range) return nullptr;
  // Some drivers begin at 0, which is no exposure.
  range->minimum = std::max(range->minimum, 1);
  const auto period = static_cast<int>(std::floor(1e3 * kSteps_per_ms / frame_rate_hz));
  const int most = std::min(range->maximum, period);
  if (most <= range->minimum) return nullptr;
  const std::optional<int> automatic = find_automatic(port);
  return std::make_shared<V4l2Exposure>(std::move(port), std::move(name), *range, automatic, most);
}

std::shared_ptr<CameraExposure> open_v4l2_exposure(const std::string& device, std::string name, double frame_rate_hz) {
  const int descriptor = ::open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  const std::shared_ptr<int> open(new int(descriptor), [](const int* it) {
    ::close(*it);
    delete it;
  });
  return find_v4l2_exposure([open](unsigned long request, void* argument) { return ::ioctl(*open, request, argument); },
                            std::move(name), frame_rate_hz);
}

}  // namespace pellucida
