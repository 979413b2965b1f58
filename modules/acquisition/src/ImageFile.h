#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

#include "Grey.h"
#include "PhysicalSize.h"

namespace pellucida {

/// What an image file says before its pixels are read.
struct ImageFileInfo {
  int width_px = 0;
  int height_px = 0;
  int bit_depth = 8;     ///< 8 or 16
  long page_count = 1;   ///< above 1 only of a TIFF
  bool cut_off = false;  ///< a TIFF of which pages behind the last one can't be found
  PhysicalSize physical;
};

/// The kinds of image file read here, by their first bytes.
enum class ImageKind { kNone, kPng, kTiff, kJpeg, kBmp };
ImageKind image_kind(const std::filesystem::path& file);

/// Whether a file is called an image, whatever it holds.
bool has_image_name(const std::filesystem::path& file);

/// Throws InputError, one line, when the file is broken, larger than `most_megapixels`, or holds pixels other than 8 or
/// 16 bit unsigned integers.
ImageFileInfo read_image_info(const std::filesystem::path& file, double most_megapixels);

/// Throws InputError when an image of this size is larger than the user wants to see opened.
void require_size(const std::string& name, std::uint64_t width_px, std::uint64_t height_px, double most_megapixels);

/// The pixels, as grey, of a file with one page; errors as for the info. PNG and BMP are read through
/// ITK, TIFF by TiffPages, JPEG by OpenCV.
GreyImage read_image(const std::filesystem::path& file, double most_megapixels);

}  // namespace pellucida
