#include "CameraSource.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <opencv2/videoio.hpp>
#include <system_error>

#include "GapCounter.h"
#include "MatGrey.h"
#include "SourceCalibration.h"
#include "V4l2Exposure.h"
#include "VideoFileSource.h"
#include "pellucida/acquisition/FolderContent.h"
#include "pellucida/core/Clock.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

// The cameras that are there, for the text of an error.
std::string cameras_present() {
  std::vector<std::string> names;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", status)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("video") && name.find_first_not_of("0123456789", 5) == std::string::npos && name.size() > 5) {
      names.push_back("v4l2:" + name.substr(5));
    }
  }
  if (names.empty()) return "no camera is connected: plug one in";
  std::sort(names.begin(), names.end(), [](const auto& left, const auto& right) { return natural_less(left, right); });
  std::string text = "there are";
  for (const auto& name : names) text += ' ' + name;
  return text;
}

std::string device_path(int number) {
  return "/dev/video" + std::to_string(number);
}

// Asks the system first: its reason is better than OpenCV's plain no.
void require_device(const std::string& name, int number) {
  const std::string device = device_path(number);
  const int descriptor = ::open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor >= 0) {
    ::close(descriptor);
    return;
  }
  const int reason = errno;
  const std::string what =
      name + ": " + device + " can't be opened (" + std::generic_category().message(reason) + "); ";
  if (reason == EACCES || reason == EPERM) throw DeviceError(what + "add yourself to the group video and log in again");
  if (reason == EBUSY) throw DeviceError(what + "close the program that uses it");
  throw DeviceError(what + cameras_present());
}

class CameraSource final : public FrameSource {
 public:
  CameraSource(int number, const std::string& name, const SourceOptions& options) {
    silence_video_libraries();
    info_.name = name;
    info_.live = true;
    require_device(name, number);
    if (!capture_.open(number, cv::CAP_V4L2)) {
      throw DeviceError(name + ": the device is no camera this build can read; " + cameras_present());
    }
    // The first image shows the true size; it is not kept.
    if (!capture_.read(pixels_))
      throw DeviceError(name + ": the camera delivers no image; check its cable and other users");
    info_.width_px = pixels_.cols;
    info_.height_px = pixels_.rows;

    check_options(options);
    const double rate_hz = capture_.get(cv::CAP_PROP_FPS);
    PhysicalSize metadata;
    if (std::isfinite(rate_hz) && rate_hz > 0.0) metadata.frame_rate_hz = rate_hz;
    settle_pixel_size(info_, options, metadata);
    settle_frame_rate(info_, options, metadata);
    gaps_ = GapCounter(info_.frame_rate_hz);
    exposure_ = open_v4l2_exposure(device_path(number), name, info_.frame_rate_hz);
  }

  const SourceInfo& info() const noexcept override { return info_; }
  std::shared_ptr<CameraExposure> exposure() override { return exposure_; }

  std::optional<Frame> next() override {
    const bool read = capture_.read(pixels_);
    const double arrival_s = clock_.now_s();
    if (!read || pixels_.cols != info_.width_px || pixels_.rows != info_.height_px) {
      throw DeviceError(info_.name + ": the camera delivers no images since frame " + std::to_string(last_index_) +
                        "; check its cable");
    }
    Frame frame;
    frame.time_s = time_of(1e-3 * capture_.get(cv::CAP_PROP_POS_MSEC), arrival_s);
    const GapCounter::Place place = gaps_.add(frame.time_s);
    frame.frame_index = last_index_ = place.frame_index;
    frame.gap_count = place.gap_count;
    frame.image = Frozen(make_frame(grey_from_mat(pixels_).view(info_.pixel_size_um), frame.time_s, frame.frame_index));
    return frame;
  }

 private:
  // Since the first frame, by the driver's stamp of the exposure's end where it gives one, else by the arrival. What is
  // decided at the first frame holds for all: the two clocks may differ.
  double time_of(double driver_s, double arrival_s) {
    const bool stamped = std::isfinite(driver_s) && driver_s > 0.0;
    if (last_index_ < 0) {
      by_driver_ = stamped;
      first_s_ = stamped ? driver_s : arrival_s;
    }
    if (by_driver_ && !stamped) throw DeviceError(info_.name + ": the driver gives no time for an image");
    return (by_driver_ ? driver_s : arrival_s) - first_s_;
  }

  SourceInfo info_;
  std::shared_ptr<CameraExposure> exposure_;
  cv::VideoCapture capture_;
  cv::Mat pixels_;
  SteadyClock clock_;
  GapCounter gaps_{1.0};
  double first_s_ = 0.0;
  bool by_driver_ = false;
  long last_index_ = -1;
};

}  // namespace

std::unique_ptr<FrameSource> open_camera(const std::string& number, const std::string& name,
                                         const SourceOptions& options) {
  int value = -1;
  const auto [end, code] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (code != std::errc() || end != number.data() + number.size() || value < 0) {
    throw UsageError(name + ": \"" + number + "\" is no camera number; give v4l2:0, v4l2:1, ...");
  }
  return std::make_unique<CameraSource>(value, name, options);
}

}  // namespace pellucida
