#pragma once
#include <cstddef>
#include <cstdint>

namespace pellucida {

enum class PixelFormat { kGray8, kGray16 };

/// A grey image owned elsewhere, row 0 at the top (world frame W: x right, y down, origin at the centre of the top-left
/// pixel). Pixel (column, row) lies at (column, row) * pixel_size_um.
struct ImageView {
  const void* data = nullptr;  ///< first byte of row 0; uint8_t or uint16_t by `format`
  PixelFormat format = PixelFormat::kGray8;
  int width_px = 0;
  int height_px = 0;
  std::ptrdiff_t row_bytes = 0;  ///< distance between rows; at least width_px * bytes per pixel
  double pixel_size_um = 0.0;    ///< edge of a square pixel, > 0
};

}  // namespace pellucida
