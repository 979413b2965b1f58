#pragma once
#include <filesystem>
#include <optional>

#include "ImageFile.h"

namespace pellucida {

/// What the outermost structure of an image file says.
struct ImageStructure {
  std::optional<double> pixel_size_um;  ///< PNG's physical size, where it may be a microscope's
  int width_px = 0;
  int height_px = 0;
};

/// Looks at the structure of a PNG, JPEG or BMP file before any decoder does: a decoder that meets a torn head prints
/// to stderr, makes up the missing pixels, or (libpng below ITK) ends the program. Throws InputError, one line, when
/// the file is cut off, its head is damaged or its size above `most_megapixels`, and for a BMP with run lengths, which
/// ITK decodes beyond its pixels. A TIFF is not looked at here.
ImageStructure check_structure(const std::filesystem::path& file, ImageKind kind, double most_megapixels);

}  // namespace pellucida
