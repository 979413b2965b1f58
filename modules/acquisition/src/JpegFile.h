#pragma once
#include <filesystem>

#include "Grey.h"

namespace pellucida {

/// The luminance of a JPEG, as its pixels are stored (no turning by a camera's note on how it was held). Through
/// libjpeg itself: ITK's reader ends the program on some damaged files, OpenCV's prints what it mends and keeps it.
/// What was mended is in the image's `damage`. Throws InputError when the file can't be decoded, or is a picture in
/// more than a hundred passes, which takes a small file hours.
GreyImage read_jpeg(const std::filesystem::path& file);

}  // namespace pellucida
