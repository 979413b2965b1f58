#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "pellucida/core/ImageView.h"

namespace pellucida {

/// A grey image of our own, float, row by row, 0..1 of the format's range. Coordinates in px, pixel centres at whole
/// numbers.
struct GrayImage {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;

  float at(int x, int y) const noexcept { return pixels[static_cast<std::size_t>(y) * width + x]; }

  /// Bilinear; outside the image the nearest border pixel counts.
  float sample(double x, double y) const noexcept {
    const float fx = static_cast<float>(std::clamp(x, 0.0, width - 1.001));
    const float fy = static_cast<float>(std::clamp(y, 0.0, height - 1.001));
    const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
    const float tx = fx - static_cast<float>(ix), ty = fy - static_cast<float>(iy);
    const float* row = pixels.data() + static_cast<std::size_t>(iy) * width + ix;
    const float top = row[0] + tx * (row[1] - row[0]);
    const float bottom = row[width] + tx * (row[width + 1] - row[width]);
    return top + ty * (bottom - top);
  }
  float sample(const Eigen::Vector2d& p) const noexcept { return sample(p.x(), p.y()); }

  /// `count` bilinear samples at from, from + step, ... into `out`.
  void sample_line(const Eigen::Vector2d& from, const Eigen::Vector2d& step, int count, float* out) const noexcept {
    for (int k = 0; k < count; ++k) out[k] = sample(from.x() + k * step.x(), from.y() + k * step.y());
  }

  bool inside(const Eigen::Vector2d& p, double margin = 0.0) const noexcept {
    return p.x() >= margin && p.y() >= margin && p.x() <= width - 1 - margin && p.y() <= height - 1 - margin;
  }
};

/// Copies `view` into `image` (whose memory is kept). Images below 8 x 8 are padded to that by repeating the border.
void load(const ImageView& view, GrayImage& image);

/// `image` blurred by a Gaussian of `sigma_px` and reduced by a whole `factor`: pixel (x, y) of the result represents
/// (x, y) * factor of the input.
GrayImage reduced(const GrayImage& image, double sigma_px, int factor);

/// Standard deviation of the pixel noise, from differences of neighbours (robust: half the pixels may carry texture).
double noise_level(const GrayImage& image);

}  // namespace pellucida
