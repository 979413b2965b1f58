#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core.hpp>
#include <string>

namespace pellucida {

/// The pictures of a video file's first video stream, one after another, by FFmpeg's libraries. (OpenCV's reader above
/// them keeps to itself what they could not decode.)
///
/// Whatever a decoder or a container's reader complains of, or mends, counts as damage of the picture that it was
/// reading; the pictures behind it are damaged too, up to the next one that needs no other. Nothing is printed.
class VideoDecoder {
 public:
  /// Nothing is thrown for a file that is no video: see `is_open`.
  explicit VideoDecoder(const std::filesystem::path& file);
  ~VideoDecoder();
  VideoDecoder(const VideoDecoder&) = delete;
  VideoDecoder& operator=(const VideoDecoder&) = delete;

  bool is_open() const noexcept;
  int width_px() const noexcept;      ///< as shown: turned as the file asks
  int height_px() const noexcept;     ///< the same
  double rate_hz() const noexcept;    ///< 0 for unknown
  long frame_count() const noexcept;  ///< stated by the container, else from its duration; 0 for unknown

  /// Decodes the next picture; false at the end of what can be read.
  bool read();
  /// The picture read last: 8 bit blue-green-red.
  const cv::Mat& picture() const noexcept;
  /// Its time in the stream, s; NaN where it has none.
  double stamp_s() const noexcept;
  bool damaged() const noexcept;
  /// What was complained of last, in the library's words.
  const std::string& complaint() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
