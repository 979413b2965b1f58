#pragma once
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace pellucida {

/// The ooplasm's grain at rest: a square of side 2 * `radius_um` about the cell's centre, zero mean, unit deviation:
/// fine granules on a slow mottling. Seeded.
class GranularTexture {
 public:
  GranularTexture(double radius_um, double finest_um, std::uint64_t seed);
  /// Value at a rest place relative to the centre, um; 0 outside the square. `sharpness` 1: the whole grain; 0: without
  /// its fine part, for material squeezed so much that its granules would only alias.
  float at(float x_um, float y_um, float sharpness) const noexcept;

 private:
  cv::Mat1f fine_, coarse_;
  float origin_um_ = 0.0f, inverse_step_ = 0.0f;
};

/// A bank of standard normal numbers, drawn once; each frame reads it from another place.
class NoiseBank {
 public:
  explicit NoiseBank(std::uint64_t seed);
  /// `count` numbers for row `row` of frame `frame`; `count` at most 8192.
  const float* row(long frame, int row) const noexcept;

 private:
  std::vector<float> numbers_;
  std::uint64_t seed_;
};

/// Draws seeded debris into a picture of transmittances (CV_32F, 1 = clear): small rings out of focus.
void draw_debris(cv::Mat1f& transmittance, int count, double max_radius_um, double pixel_size_um, std::uint64_t seed);

}  // namespace pellucida
