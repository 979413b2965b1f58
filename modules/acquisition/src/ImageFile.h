#pragma once
#include <filesystem>

#include "Grey.h"
#include "PhysicalSize.h"

namespace pellucida {

/// What an image file says before its pixels are read.
struct ImageFileInfo {
  int width_px = 0;
  int height_px = 0;
  int bit_depth = 8;    ///< 8 or 16
  long page_count = 1;  ///< above 1 only of a TIFF
  PhysicalSize physical;
};

/// The kinds of image file read here, by their first bytes.
enum class ImageKind { kNone, kPng, kTiff, kJpeg, kBmp };
ImageKind image_kind(const std::filesystem::path& file);

/// Throws InputError, one line, when the file is broken or holds pixels other than 8 or 16 bit unsigned integers.
ImageFileInfo read_image_info(const std::filesystem::path& file);

/// The pixels, as grey, of a file with one page; errors as for the info. PNG and BMP are read through
/// ITK, TIFF by TiffPages, JPEG by OpenCV.
GreyImage read_image(const std::filesystem::path& file);

}  // namespace pellucida
