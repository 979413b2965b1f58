#pragma once
#include <filesystem>

#include "Grey.h"

namespace pellucida {

/// The luminance of a JPEG, as its pixels are stored (no turning by a camera's note on how it was held). Reads through
/// OpenCV: ITK's JPEG reader ends the program on some damaged files.
/// Throws InputError when the file can't be decoded.
GreyImage read_jpeg(const std::filesystem::path& file);

}  // namespace pellucida
