#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pellucida/core/ImageView.h"

namespace pellucida {

/// A grey image with its own pixels, rows without padding.
struct GreyImage {
  int width_px = 0;
  int height_px = 0;
  PixelFormat format = PixelFormat::kGray8;
  std::vector<std::uint8_t> bytes;  ///< width * height * bytes a pixel, host byte order
  std::string damage;               ///< what the decoder had to make up for, in its words; empty for none

  int bit_depth() const noexcept { return format == PixelFormat::kGray16 ? 16 : 8; }
  std::size_t pixel_count() const noexcept {
    return static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  }
  ImageView view(double pixel_size_um) const noexcept;
};

/// An image of `width_px` x `height_px`, all black.
GreyImage make_grey(int width_px, int height_px, int bit_depth);

/// Pixels of `channel_count` interleaved samples (1 grey, 2 grey and alpha, 3 red green blue, 4 with alpha; alpha is
/// ignored) to grey: luminance Y = 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601), rounded; equal channels keep their value
/// exactly. `bytes_per_sample` is 1 or 2; `from` holds pixel_count * channel_count samples, `to` pixel_count.
void to_grey(const void* from, int channel_count, int bytes_per_sample, std::size_t pixel_count, void* to);

}  // namespace pellucida
