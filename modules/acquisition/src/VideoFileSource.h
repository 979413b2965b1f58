#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "pellucida/acquisition/OpenSource.h"

namespace pellucida {

/// A video file, decoded by FFmpeg through OpenCV to 8 bit grey.
///
/// Time comes from the stream's own stamps; a stamp that leaves out a frame period counts as a gap. A rate the user
/// gives stretches the stamps (a recording that plays slower than it was taken). A file that is cut off gives its
/// frames up to the cut, then `next()` throws. Errors: InputError for a file that is no video or has no frame, then the
/// options' UsageError.
std::unique_ptr<FrameSource> open_video_file(const std::filesystem::path& file, const std::string& name,
                                             const SourceOptions& options);

/// Keeps OpenCV and FFmpeg from writing to stderr: what is wrong is said once, by an exception.
void silence_video_libraries();

}  // namespace pellucida
