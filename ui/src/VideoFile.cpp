#include "VideoFile.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <system_error>

#include "pellucida/core/Error.h"

namespace pellucida {

class VideoFile::Impl {
 public:
  Impl(const std::filesystem::path& file, int width_px, int height_px, double frame_rate_hz)
      : file_(file),
        part_(file.parent_path() / (file.stem().string() + ".part" + file.extension().string())),
        size_(width_px, height_px) {
    const bool is_avi = file.extension() == ".avi";
    for (const char* code : is_avi ? kAvi : kMp4) {
      const int fourcc = cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]);
      if (writer_.open(part_.string(), cv::CAP_FFMPEG, fourcc, frame_rate_hz, size_, true)) return;
    }
    remove_part();
    throw OutputError("the video " + file.string() +
                      " can't be written; choose a folder that exists and may be written, and .mp4 or .avi");
  }
  ~Impl() {
    writer_.release();
    remove_part();
  }

  void add(const std::uint8_t* rgb, std::ptrdiff_t row_bytes) {
    const cv::Mat given(size_, CV_8UC3, const_cast<std::uint8_t*>(rgb), static_cast<std::size_t>(row_bytes));
    cv::cvtColor(given, picture_, cv::COLOR_RGB2BGR);
    writer_.write(picture_);
    ++count_;
  }

  void close() {
    writer_.release();
    // OpenCV keeps write errors to itself: the file is asked how long it is. Containers round their duration.
    cv::VideoCapture written(part_.string(), cv::CAP_FFMPEG);
    const bool is_whole =
        written.isOpened() && std::abs(written.get(cv::CAP_PROP_FRAME_COUNT) - static_cast<double>(count_)) < 1.5;
    written.release();
    std::error_code refused;
    if (is_whole) std::filesystem::rename(part_, file_, refused);
    if (!is_whole || refused) {
      throw OutputError("the video " + file_.string() + " can't be written whole; check the free space of its folder");
    }
  }

 private:
  static constexpr const char* kAvi[] = {"FFV1", "MJPG"};
  static constexpr const char* kMp4[] = {"avc1", "mp4v"};

  void remove_part() {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }

  std::filesystem::path file_, part_;
  cv::Size size_;
  cv::VideoWriter writer_;
  cv::Mat picture_;
  long count_ = 0;
};

VideoFile::VideoFile(const std::filesystem::path& file, int width_px, int height_px, double frame_rate_hz)
    : impl_(std::make_unique<Impl>(file, width_px, height_px, frame_rate_hz)) {}
VideoFile::~VideoFile() = default;

void VideoFile::add(const std::uint8_t* rgb, std::ptrdiff_t row_bytes) {
  impl_->add(rgb, row_bytes);
}
void VideoFile::close() {
  impl_->close();
}

}  // namespace pellucida
