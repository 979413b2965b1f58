#include "Grey.h"

#include <algorithm>

namespace pellucida {
namespace {

// Weights in 1/65536 that add up to exactly one.
constexpr std::uint32_t kRed = 19595;
constexpr std::uint32_t kGreen = 38470;
constexpr std::uint32_t kBlue = 7471;
static_assert(kRed + kGreen + kBlue == 65536);

template <class T>
void convert(const T* from, int channel_count, std::size_t pixel_count, T* to) {
  const auto step = static_cast<std::size_t>(channel_count);
  for (std::size_t i = 0; i < pixel_count; ++i, from += step) {
    if (channel_count < 3) {
      to[i] = from[0];
    } else {
      // At most 65535 * 65536 + 32768, which 32 bit still hold.
      to[i] = static_cast<T>((kRed * from[0] + kGreen * from[1] + kBlue * from[2] + 32768U) >> 16U);
    }
  }
}

}  // namespace

ImageView GreyImage::view(double pixel_size_um) const noexcept {
  return {.data = bytes.data(),
          .format = format,
          .width_px = width_px,
          .height_px = height_px,
          .row_bytes = static_cast<std::ptrdiff_t>(width_px) * (bit_depth() / 8),
          .pixel_size_um = pixel_size_um};
}

GreyImage make_grey(int width_px, int height_px, int bit_depth) {
  GreyImage image{width_px, height_px, bit_depth == 16 ? PixelFormat::kGray16 : PixelFormat::kGray8, {}};
  image.bytes.resize(image.pixel_count() * static_cast<std::size_t>(bit_depth / 8));
  return image;
}

void to_grey(const void* from, int channel_count, int bytes_per_sample, std::size_t pixel_count, void* to) {
  if (bytes_per_sample == 2) {
    convert(static_cast<const std::uint16_t*>(from), channel_count, pixel_count, static_cast<std::uint16_t*>(to));
  } else {
    convert(static_cast<const std::uint8_t*>(from), channel_count, pixel_count, static_cast<std::uint8_t*>(to));
  }
}

}  // namespace pellucida
