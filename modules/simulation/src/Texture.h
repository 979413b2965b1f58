#pragma once
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace pellucida {

/// One granule of the ooplasm: where it lies at rest (OoplasmFlow's coordinates), its size, and how much lighter (or
/// darker, below 0) it is.
struct Granule {
  float ratio, angle, sigma_um, strength;
};

/// Granules spread evenly over a disc, fine and coarse ones, whose sum has about unit deviation. Seeded.
std::vector<Granule> make_granules(double disc_radius_um, double finest_sigma_um, std::uint64_t seed);

/// Adds a granule to `grain` (CV_32F) at a place in px; sigma in px.
void draw_granule(cv::Mat1f& grain, float x_px, float y_px, float sigma_px, float strength) noexcept;

/// Slow mottling at rest: a square of side 2 * `radius_um` about the centre, zero mean, unit deviation. Seeded.
class Mottling {
 public:
  Mottling(double radius_um, std::uint64_t seed);
  /// Value at a rest place relative to the centre, um; 0 outside the square.
  float at(float x_um, float y_um) const noexcept;

 private:
  cv::Mat1f cloud_;
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
