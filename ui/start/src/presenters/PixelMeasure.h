#pragma once
#include <string>
#include <string_view>

namespace pellucida {

/// A line drawn on an image, in its pixels.
struct DrawnLine {
  double x0_px = 0.0, y0_px = 0.0;
  double x1_px = 0.0, y1_px = 0.0;

  double length_px() const noexcept;
};

/// A pixel's edge by a line of known length.
struct PixelMeasure {
  double pixel_size_um = 0.0;   ///< 0 where there is none
  double uncertainty_um = 0.0;  ///< half the 95 % interval, from the ends' places: each to a pixel
  std::string text;             ///< "0.825 ± 0.006 µm per px"; what is missing or wrong, where there is none
  std::string typed;            ///< the size as it is put into a field: as many digits as it is worth, and one more
};

/// `length`: as typed, um. A line of fewer than 20 px measures nothing.
PixelMeasure measure_pixel(const DrawnLine& line, std::string_view length);

}  // namespace pellucida
