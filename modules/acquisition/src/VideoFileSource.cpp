#include "VideoFileSource.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core/utils/logger.hpp>

#include "ContainerExtent.h"
#include "GapCounter.h"
#include "Grey.h"
#include "ImageFile.h"
#include "MatGrey.h"
#include "SourceCalibration.h"
#include "VideoDecoder.h"
#include "pellucida/core/Error.h"
#include "pellucida/core_vtk/DamageCounter.h"
#include "pellucida/core_vtk/SceneData.h"

namespace pellucida {
namespace {

// A rate beyond this is a container's time base, not a camera's frame rate.
constexpr double kFastest_hz = 10000.0;

class VideoFileSource final : public FrameSource {
 public:
  VideoFileSource(const std::filesystem::path& file, const std::string& name, const SourceOptions& options)
      : file_(file), extent_(container_extent(file)) {
    silence_video_libraries();
    info_.name = name;
    open();
    info_.width_px = decoder_->width_px();
    info_.height_px = decoder_->height_px();
    require_size(name, static_cast<std::uint64_t>(std::max(info_.width_px, 0)),
                 static_cast<std::uint64_t>(std::max(info_.height_px, 0)), options.most_megapixels);
    if (const long count = decoder_->frame_count(); count >= 1) info_.frame_count = count;

    // Without a first frame there is nothing to open.
    if (!decoder_->read()) throw InputError(name + ": a video without a readable frame" + cut_text());
    restart_first();

    // What the container says of time, then what the user says.
    check_options(options);
    const double rate_hz = decoder_->rate_hz();
    PhysicalSize metadata;
    if (std::isfinite(rate_hz) && rate_hz > 0.0 && rate_hz <= kFastest_hz) metadata.frame_rate_hz = rate_hz;
    settle_pixel_size(info_, options, metadata);
    settle_frame_rate(info_, options, metadata);
    stream_rate_hz_ = metadata.frame_rate_hz.value_or(info_.frame_rate_hz);
    gaps_ = GapCounter(stream_rate_hz_);
  }

  const SourceInfo& info() const noexcept override { return info_; }

  std::optional<Frame> next() override {
    if (ended_) return std::nullopt;
    if (!decoder_->read()) {
      ended_ = true;
      check_end();
      return std::nullopt;
    }
    const cv::Mat& pixels = decoder_->picture();
    if (pixels.cols != info_.width_px || pixels.rows != info_.height_px) {
      throw InputError(info_.name + ": the picture changes its size after frame " + std::to_string(last_index_) +
                       "; cut the video there");
    }
    // Stamps are counted from the first frame on; a stream without them counts frames.
    const double stamp_s = decoder_->stamp_s();
    if (delivered_ == 0) first_stamp_s_ = stamp_s;
    const bool stamped = std::isfinite(stamp_s) && (delivered_ == 0 || stamp_s > last_stamp_s_);
    const double stream_s = stamped ? stamp_s - first_stamp_s_ : last_stream_s_ + 1.0 / stream_rate_hz_;
    const GapCounter::Place place = gaps_.add(stream_s);
    last_stamp_s_ = stamped ? stamp_s : last_stamp_s_;
    last_stream_s_ = stream_s;
    last_index_ = place.frame_index;
    ++delivered_;

    Frame frame;
    frame.time_s = stream_s * stream_rate_hz_ / info_.frame_rate_hz;
    frame.frame_index = place.frame_index;
    frame.gap_count = place.gap_count;
    frame.damage = damage_.add(decoder_->damaged(), decoder_->complaint());
    frame.image = Frozen(make_frame(grey_from_mat(pixels).view(info_.pixel_size_um), frame.time_s, frame.frame_index));
    return frame;
  }

  bool restart() override {
    restart_first();
    return true;
  }

 private:
  void open() {
    decoder_ = std::make_unique<VideoDecoder>(file_);
    if (!decoder_->is_open()) {
      if (!extent_.has_index) {
        throw InputError(info_.name + ": cut off (an MP4 without its index can't be read); copy or record it again");
      }
      throw InputError(info_.name + ": neither a video nor an image this build can read; " +
                       "give AVI, MP4, MKV, MOV, PNG, TIFF, JPEG or BMP");
    }
  }

  // Opening anew is the one way back that is exact in every container.
  void restart_first() {
    open();
    gaps_ = GapCounter(stream_rate_hz_);
    first_stamp_s_ = last_stamp_s_ = last_stream_s_ = 0.0;
    last_index_ = -1;
    delivered_ = 0;
    damage_ = {};
    ended_ = false;
  }

  std::string cut_text() const { return extent_.cut_off() ? " (the file is cut off)" : ""; }

  // The stream has ended: was that its end? The file's own structure shows a cut with certainty. The frame count counts
  // where a container keeps it (AVI, MP4); elsewhere it is only guessed from the duration, which sound may make longer.
  void check_end() const {
    const long expected = info_.frame_count.value_or(0);
    const long missing = expected - (last_index_ + 1);
    const bool counted = extent_.kind == ContainerExtent::Kind::kRiff || extent_.kind == ContainerExtent::Kind::kIso;
    // An AVI counts exactly; one frame that can't be found there shifts the times behind it.
    const bool exact = extent_.kind == ContainerExtent::Kind::kRiff;
    const bool few = counted && missing > (exact ? 0L : std::max(2L, expected / 100));
    const bool cut = extent_.cut_off() && (missing > 0 || !counted);
    if (!few && !cut) return;
    std::string text = info_.name;
    text += extent_.cut_off() ? ": broken off after frame " + std::to_string(last_index_) : ": damaged";
    text += " (" + std::to_string(delivered_) + " frames were read";
    if (missing > 0) text += ", about " + std::to_string(missing) + " of " + std::to_string(expected) + " are missing";
    throw InputError(text + "); copy or record it again");
  }

  std::filesystem::path file_;
  ContainerExtent extent_;
  SourceInfo info_;
  std::unique_ptr<VideoDecoder> decoder_;
  DamageCounter damage_;
  double stream_rate_hz_ = 1.0;
  GapCounter gaps_{1.0};
  double first_stamp_s_ = 0.0;
  double last_stamp_s_ = 0.0;
  double last_stream_s_ = 0.0;
  long last_index_ = -1;
  long delivered_ = 0;
  bool ended_ = false;
};

}  // namespace

void silence_video_libraries() {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  // OpenCV hands this to FFmpeg when it opens its first file; a user who set it wants to see more.
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
}

std::unique_ptr<FrameSource> open_video_file(const std::filesystem::path& file, const std::string& name,
                                             const SourceOptions& options) {
  return std::make_unique<VideoFileSource>(file, name, options);
}

}  // namespace pellucida
