#include "VideoDecoder.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libswscale/swscale.h>
}

#include <cmath>
#include <cstdarg>
#include <limits>
#include <map>
#include <mutex>
#include <opencv2/imgproc.hpp>

namespace pellucida {
namespace {

// What a library complains of, by the object it says it of. Decoders complain on threads of their own.
struct Complaints {
  long count = 0;
  std::string newest;
};

std::mutex complaints_mutex;
std::map<const void*, Complaints*>& complaints_by_object() {
  static std::map<const void*, Complaints*> all;
  return all;
}

// In place of FFmpeg's own, which prints.
void take_complaint(void* object, int level, const char* pattern, va_list arguments) {
  if (level > AV_LOG_ERROR || !object) return;
  char text[256];
  std::vsnprintf(text, sizeof text, pattern, arguments);
  const std::lock_guard lock(complaints_mutex);
  const auto found = complaints_by_object().find(object);
  if (found == complaints_by_object().end()) return;
  ++found->second->count;
  std::string& newest = found->second->newest;
  newest.assign(text);
  while (!newest.empty() && (newest.back() == '\n' || newest.back() == '.')) newest.pop_back();
}

struct FreeFormat {
  void operator()(AVFormatContext* context) const noexcept { avformat_close_input(&context); }
};
struct FreeCodec {
  void operator()(AVCodecContext* context) const noexcept { avcodec_free_context(&context); }
};
struct FreeFrame {
  void operator()(AVFrame* frame) const noexcept { av_frame_free(&frame); }
};
struct FreePacket {
  void operator()(AVPacket* packet) const noexcept { av_packet_free(&packet); }
};

// More packets than any decoder holds back.
constexpr std::size_t kMostPacketsKept = 4096;

double seconds(AVRational base) {
  return base.num > 0 && base.den > 0 ? av_q2d(base) : 0.0;
}

}  // namespace

class VideoDecoder::Impl {
 public:
  explicit Impl(const std::filesystem::path& file) {
    av_log_set_callback(take_complaint);
    AVFormatContext* opened = nullptr;
    if (avformat_open_input(&opened, file.c_str(), nullptr, nullptr) < 0) return;
    format_.reset(opened);
    if (avformat_find_stream_info(opened, nullptr) < 0) return;
    for (unsigned i = 0; i < opened->nb_streams && !stream_; ++i) {
      if (opened->streams[i]->codecpar->codec_type == AVMEDIA_TYPE_VIDEO) stream_ = opened->streams[i];
    }
    if (!stream_) return;
    const AVCodec* codec = avcodec_find_decoder(stream_->codecpar->codec_id);
    if (!codec) return;
    codec_.reset(avcodec_alloc_context3(codec));
    if (avcodec_parameters_to_context(codec_.get(), stream_->codecpar) < 0) return;
    codec_->thread_count = 0;
    // A picture at a time, so that a complaint belongs to the packet at hand.
    codec_->thread_type = FF_THREAD_SLICE;
    codec_->err_recognition |= AV_EF_CRCCHECK;
    if (avcodec_open2(codec_.get(), codec, nullptr) < 0) return;
    ahead_.reset(av_packet_alloc());
    frame_.reset(av_frame_alloc());
    find_turn();
    listen(true);
    open_ = true;
  }

  ~Impl() {
    if (open_) listen(false);
    sws_freeContext(scale_);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  bool read() {
    for (;;) {
      const int got = avcodec_receive_frame(codec_.get(), frame_.get());
      if (got == 0) break;
      if (got == AVERROR_EOF || (got != AVERROR(EAGAIN) && ended_)) return false;
      if (!feed()) return false;
    }
    settle_damage();
    convert();
    return true;
  }

  void listen(bool on) {
    const std::lock_guard lock(complaints_mutex);
    const void* readers[] = {format_.get(), format_->pb, codec_.get()};
    for (const void* object : readers) {
      if (!object) continue;
      if (on) {
        complaints_by_object()[object] = &complaints_;
      } else {
        complaints_by_object().erase(object);
      }
    }
  }

  long complaint_count() const {
    const std::lock_guard lock(complaints_mutex);
    return complaints_.count;
  }

  // Reads the stream's next packet into `ahead_`; what the container complains of on the way makes it `gap_ahead_`.
  void look_ahead() {
    const long before = complaint_count();
    av_packet_unref(ahead_.get());
    do {
      av_packet_unref(ahead_.get());
      at_end_ = av_read_frame(format_.get(), ahead_.get()) < 0;
    } while (!at_end_ && ahead_->stream_index != stream_->index);
    settled_complaints_ = complaint_count();
    gap_ahead_ = settled_complaints_ > before;
  }

  // Gives the decoder its next packet. Packets are numbered; what goes wrong with one, or right behind it, is kept
  // under its number until its picture comes out. What is lost between two is missed by pictures that need others.
  bool feed() {
    if (ended_) return false;
    if (packet_count_ == 0) look_ahead();
    if (at_end_) {
      ended_ = true;
      return avcodec_send_packet(codec_.get(), nullptr) >= 0;
    }
    const bool key = (ahead_->flags & AV_PKT_FLAG_KEY) != 0;
    const bool lost_before = gap_ahead_;
    bool faulty = (ahead_->flags & AV_PKT_FLAG_CORRUPT) != 0;
    codec_->reordered_opaque = packet_count_;
    const long before = complaint_count();
    const int sent = avcodec_send_packet(codec_.get(), ahead_.get());
    faulty = faulty || (sent < 0 && sent != AVERROR(EAGAIN)) || complaint_count() > before;
    look_ahead();
    faulty = faulty || gap_ahead_;
    chain_damaged_ = faulty || (!key && (chain_damaged_ || lost_before));
    damaged_by_packet_[packet_count_] = chain_damaged_;
    if (damaged_by_packet_.size() > kMostPacketsKept) damaged_by_packet_.erase(damaged_by_packet_.begin());
    ++packet_count_;
    return true;
  }

  // Of the picture in `frame_`. Some decoders look at a packet only when its picture is asked for.
  void settle_damage() {
    const long number = static_cast<long>(frame_->reordered_opaque);
    const long count = complaint_count();
    if (count > settled_complaints_ && packet_count_ > 0) {
      // Complaints since the last picture: of the newest packet, or of one that gave no picture.
      chain_damaged_ = true;
      damaged_by_packet_[packet_count_ - 1] = true;
    }
    settled_complaints_ = count;
    const auto found = damaged_by_packet_.find(number);
    damaged_ = (found != damaged_by_packet_.end() && found->second) || frame_->decode_error_flags != 0 ||
               (frame_->flags & AV_FRAME_FLAG_CORRUPT) != 0;
  }

  void convert() {
    const int width = frame_->width;
    const int height = frame_->height;
    scale_ = sws_getCachedContext(scale_, width, height, static_cast<AVPixelFormat>(frame_->format), width, height,
                                  AV_PIX_FMT_BGR24, SWS_BICUBIC, nullptr, nullptr, nullptr);
    // FFmpeg writes whole blocks of pixels: beyond the end of a row, and of the last one.
    constexpr int kBlockPixels = 64;
    blocks_.create(height + 1, (width / kBlockPixels + 2) * kBlockPixels, CV_8UC3);
    upright_ = blocks_(cv::Rect(0, 0, width, height));
    if (scale_) {
      std::uint8_t* rows[] = {upright_.data};
      const int steps[] = {static_cast<int>(upright_.step[0])};
      sws_scale(scale_, frame_->data, frame_->linesize, 0, height, rows, steps);
    }
    if (turn_ >= 0) {
      cv::rotate(upright_, picture_, turn_);
    } else {
      picture_ = upright_;
    }
  }

  // Cameras that are held upright say so beside their pictures.
  void find_turn() {
    const std::uint8_t* matrix = av_stream_get_side_data(stream_, AV_PKT_DATA_DISPLAYMATRIX, nullptr);
    if (!matrix) return;
    const double angle_deg = -av_display_rotation_get(reinterpret_cast<const std::int32_t*>(matrix));
    if (!std::isfinite(angle_deg)) return;
    const int quarter = (static_cast<int>(std::lround(angle_deg / 90.0)) % 4 + 4) % 4;
    turn_ = quarter == 1 ? cv::ROTATE_90_CLOCKWISE : quarter == 2 ? cv::ROTATE_180 : -1;
    if (quarter == 3) turn_ = cv::ROTATE_90_COUNTERCLOCKWISE;
  }

  double stamp_s() const {
    const std::int64_t stamp = frame_->best_effort_timestamp;
    if (stamp == AV_NOPTS_VALUE) return std::numeric_limits<double>::quiet_NaN();
    const std::int64_t start = stream_->start_time == AV_NOPTS_VALUE ? 0 : stream_->start_time;
    return static_cast<double>(stamp - start) * seconds(stream_->time_base);
  }

  bool turned() const { return turn_ == cv::ROTATE_90_CLOCKWISE || turn_ == cv::ROTATE_90_COUNTERCLOCKWISE; }

  double rate_hz() const {
    const double rate_hz = seconds(stream_->avg_frame_rate);
    const double base_s = seconds(stream_->time_base);
    return rate_hz > 0.0 ? rate_hz : base_s > 0.0 ? 1.0 / base_s : 0.0;
  }

  long frame_count() const {
    if (stream_->nb_frames > 0) return static_cast<long>(stream_->nb_frames);
    double duration_s = static_cast<double>(format_->duration) / AV_TIME_BASE;
    if (!(duration_s > 0.0)) duration_s = static_cast<double>(stream_->duration) * seconds(stream_->time_base);
    const double count = duration_s * rate_hz();
    return count > 0.0 && count < 1e9 ? std::lround(std::floor(count + 0.5)) : 0;
  }

  std::unique_ptr<AVFormatContext, FreeFormat> format_;
  std::unique_ptr<AVCodecContext, FreeCodec> codec_;
  std::unique_ptr<AVFrame, FreeFrame> frame_;
  std::unique_ptr<AVPacket, FreePacket> ahead_;  // the next packet
  AVStream* stream_ = nullptr;
  SwsContext* scale_ = nullptr;
  cv::Mat blocks_;
  cv::Mat upright_;
  cv::Mat picture_;
  int turn_ = -1;
  bool open_ = false;
  bool at_end_ = false;     // there is no packet ahead
  bool gap_ahead_ = false;  // something was lost before the packet ahead
  bool ended_ = false;      // the decoder knows of the end
  bool damaged_ = false;
  bool chain_damaged_ = false;  // of the packet given last: it, or one that it needs
  long packet_count_ = 0;
  long settled_complaints_ = 0;
  std::map<long, bool> damaged_by_packet_;
  Complaints complaints_;
};

VideoDecoder::VideoDecoder(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}
VideoDecoder::~VideoDecoder() = default;

bool VideoDecoder::is_open() const noexcept {
  return impl_->open_;
}
int VideoDecoder::width_px() const noexcept {
  return impl_->turned() ? impl_->codec_->height : impl_->codec_->width;
}
int VideoDecoder::height_px() const noexcept {
  return impl_->turned() ? impl_->codec_->width : impl_->codec_->height;
}
double VideoDecoder::rate_hz() const noexcept {
  return impl_->rate_hz();
}
long VideoDecoder::frame_count() const noexcept {
  return impl_->frame_count();
}
bool VideoDecoder::read() {
  return impl_->read();
}
const cv::Mat& VideoDecoder::picture() const noexcept {
  return impl_->picture_;
}
double VideoDecoder::stamp_s() const noexcept {
  return impl_->stamp_s();
}
bool VideoDecoder::damaged() const noexcept {
  return impl_->damaged_;
}
const std::string& VideoDecoder::complaint() const noexcept {
  return impl_->complaints_.newest;
}

}  // namespace pellucida
