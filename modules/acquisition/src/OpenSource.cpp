#include "pellucida/acquisition/OpenSource.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "CameraSource.h"
#include "ImageFile.h"
#include "ImageSequenceSource.h"
#include "VideoFileSource.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

// The part behind `prefix`, if `input` starts with it.
std::optional<std::string> behind(const std::string& input, std::string_view prefix) {
  if (!input.starts_with(prefix)) return std::nullopt;
  return input.substr(prefix.size());
}

// Text is no video, whatever its name; FFmpeg would take some kinds of it for a playlist or a text screen.
bool is_text(const std::filesystem::path& file) {
  std::array<char, 512> bytes{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  return std::all_of(bytes.begin(), bytes.begin() + stream.gcount(), [](char c) {
    const auto value = static_cast<unsigned char>(c);
    return value >= 0x80U || std::isprint(value) != 0 || std::isspace(value) != 0;
  });
}

// A file or folder that is there and may be read.
void require_readable(const std::string& input) {
  const std::filesystem::path path(input);
  std::error_code status;
  const auto kind = std::filesystem::status(path, status).type();
  if (kind == std::filesystem::file_type::not_found)
    throw InputError(input + ": no such file or folder; check the path");
  if (status) throw InputError(input + ": can't be read (" + status.message() + "); check path and permission");
  if (kind == std::filesystem::file_type::directory) return;
  if (kind != std::filesystem::file_type::regular) throw InputError(input + ": neither a file nor a folder");
  if (std::filesystem::file_size(path, status) == 0)
    throw InputError(input + ": empty file (0 bytes); copy or record it again");
  errno = 0;
  if (!std::ifstream(path)) {
    throw InputError(input + ": can't be read (" + std::generic_category().message(errno) + "); change its permission");
  }
}

}  // namespace

std::unique_ptr<FrameSource> open_source(const std::string& input, const SourceOptions& options) {
  // Cameras are named by their kind.
  if (const auto number = behind(input, "v4l2:")) return open_camera(*number, input, options);
  for (const char* kind : {"gstreamer:", "genicam:"}) {
    if (behind(input, kind)) {
      throw DeviceError(input + ": this build has no " + std::string(kind, std::string_view(kind).size() - 1) +
                        " source; use a camera v4l2:N, or record to a video file");
    }
  }

  // Everything else lies on the disk; what it holds counts, not what it is called.
  require_readable(input);
  if (!(options.most_megapixels > 0.0 && options.most_megapixels <= 1000.0)) {
    throw UsageError("--max-megapixels must be above 0, up to 1000");
  }
  const std::filesystem::path path(input);
  if (std::filesystem::is_directory(path)) return open_image_folder(path, input, options);
  if (image_kind(path) != ImageKind::kNone) return open_image_file(path, input, options);
  if (is_text(path))
    throw InputError(input + ": a text file, not a video or an image; give AVI, MP4, MKV, MOV, PNG, TIFF, JPEG or BMP");
  return open_video_file(path, input, options);
}

}  // namespace pellucida
