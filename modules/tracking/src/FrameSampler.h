#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pellucida/core/ImageView.h"

namespace pellucida {

/// The camera's frame as the followers see it: grey values 0..1 of the format's range, read straight from the camera's
/// memory and only where asked, so that a frame costs what its contours cost. Coordinates in px, pixel centres at whole
/// numbers; outside the image the nearest border pixel counts. The image must outlive the sampler.
class FrameSampler {
 public:
  FrameSampler() = default;
  /// `view`: data, sizes of 1 or more, rows no shorter than the width.
  explicit FrameSampler(const ImageView& view) noexcept
      : width(view.width_px),
        height(view.height_px),
        data_(static_cast<const unsigned char*>(view.data)),
        row_bytes_(view.row_bytes),
        wide_(view.format == PixelFormat::kGray16) {}

  int width = 0;
  int height = 0;

  /// One pixel; 0 <= x < width, 0 <= y < height.
  float at(int x, int y) const noexcept { return wide_ ? pixel<std::uint16_t>(x, y) : pixel<std::uint8_t>(x, y); }

  /// Bilinear.
  float sample(double x, double y) const noexcept {
    return wide_ ? bilinear<std::uint16_t>(static_cast<float>(x), static_cast<float>(y))
                 : bilinear<std::uint8_t>(static_cast<float>(x), static_cast<float>(y));
  }
  float sample(const Eigen::Vector2d& p) const noexcept { return sample(p.x(), p.y()); }

  /// `count` bilinear samples at from, from + step, ... into `out`: one branch on the format for the whole line.
  void sample_line(const Eigen::Vector2d& from, const Eigen::Vector2d& step, int count, float* out) const noexcept {
    if (wide_) {
      line<std::uint16_t>(from, step, count, out);
    } else {
      line<std::uint8_t>(from, step, count, out);
    }
  }

  bool inside(const Eigen::Vector2d& p, double margin = 0.0) const noexcept {
    return p.x() >= margin && p.y() >= margin && p.x() <= width - 1 - margin && p.y() <= height - 1 - margin;
  }

 private:
  template <class Pixel>
  static constexpr float kScale = sizeof(Pixel) == 1 ? 1.0F / 255.0F : 1.0F / 65535.0F;

  template <class Pixel>
  static float read(const unsigned char* bytes) noexcept {
    Pixel value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<float>(value);
  }

  template <class Pixel>
  float pixel(int x, int y) const noexcept {
    return kScale<Pixel> *
           read<Pixel>(data_ + y * row_bytes_ + static_cast<std::ptrdiff_t>(x) * static_cast<int>(sizeof(Pixel)));
  }

  template <class Pixel>
  float bilinear(float x, float y) const noexcept {
    constexpr int size = sizeof(Pixel);
    const float fx = std::clamp(x, 0.0F, static_cast<float>(width - 1));
    const float fy = std::clamp(y, 0.0F, static_cast<float>(height - 1));
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const float tx = fx - static_cast<float>(ix), ty = fy - static_cast<float>(iy);
    // On the last column and row the weight of the missing neighbour is 0: the pixel itself replaces it.
    const std::ptrdiff_t right = ix + 1 < width ? size : 0, below = iy + 1 < height ? row_bytes_ : 0;
    const unsigned char* p = data_ + iy * row_bytes_ + static_cast<std::ptrdiff_t>(ix) * size;
    const float a = read<Pixel>(p), b = read<Pixel>(p + right);
    const float c = read<Pixel>(p + below), d = read<Pixel>(p + below + right);
    const float top = a + tx * (b - a), bottom = c + tx * (d - c);
    return kScale<Pixel> * (top + ty * (bottom - top));
  }

  template <class Pixel>
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& step, int count, float* out) const noexcept {
    const float x = static_cast<float>(from.x()), y = static_cast<float>(from.y());
    const float dx = static_cast<float>(step.x()), dy = static_cast<float>(step.y());
    for (int k = 0; k < count; ++k)
      out[k] = bilinear<Pixel>(x + static_cast<float>(k) * dx, y + static_cast<float>(k) * dy);
  }

  const unsigned char* data_ = nullptr;
  std::ptrdiff_t row_bytes_ = 0;
  bool wide_ = false;
};

/// Standard deviation of the pixel noise, from differences of neighbours on a sparse grid (robust: half the pixels may
/// carry texture); at least 1e-4.
double noise_level(const FrameSampler& image);

}  // namespace pellucida
