#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "pellucida/core_vtk/FrameSource.h"

namespace pellucida {

/// Writes frames to a file or folder; the kind follows from the name:
/// - `.avi`, `.mkv`: FFV1, lossless (8 bit); if FFmpeg lacks it, Motion JPEG in `.avi`, `.mkv` refused;
/// - `.mp4`: H.264, or MPEG-4 where that is missing; lossy (8 bit): for viewing, not for measuring;
/// - `.tif`, `.tiff`: one multi-page TIFF, lossless, 8 or 16 bit, with pixel size and frame interval as ImageJ writes
/// them;
/// - no extension: a folder of PNG, `frame_000000.png` and on, lossless, 8 or 16 bit.
class FrameWriter {
 public:
  /// Opens `output` for frames as `info` says. A folder is made if need be. Throws UsageError (unknown
  /// extension; 16 bit into a video; a folder that holds images of an earlier run), OutputError (not writable, no
  /// encoder).
  static std::unique_ptr<FrameWriter> open(const std::filesystem::path& output, const SourceInfo& info);
  virtual ~FrameWriter() = default;

  /// Frames in order. Throws OutputError.
  virtual void write(const Frame& frame) = 0;
  /// Completes the file. Throws OutputError when the file written is missing.
  virtual void close() = 0;
  /// What it writes, in words: "AVI, FFV1, lossless".
  virtual std::string format() const = 0;
};

}  // namespace pellucida
