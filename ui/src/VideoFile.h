#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace pellucida {

/// A film written picture by picture: `.mp4` (H.264, else MPEG-4) or `.avi` (FFV1, lossless, else Motion JPEG). It is
/// written under another name beside its own and has its own once it is whole.
class VideoFile {
 public:
  /// Both sizes in px and even, the rate above 0. Throws OutputError where the folder refuses, or no encoder is there.
  VideoFile(const std::filesystem::path& file, int width_px, int height_px, double frame_rate_hz);
  /// Without `close` nothing is left.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// The next picture: 8 bits each of red, green, blue, rows of `row_bytes` from the top.
  void add(const std::uint8_t* rgb, std::ptrdiff_t row_bytes);
  /// Throws OutputError when not every picture is in the file, as on a full disk.
  void close();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pellucida
