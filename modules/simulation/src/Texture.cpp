#include "Texture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "EdgeProfile.h"

namespace pellucida {
namespace {

// Uniform and normal numbers made by hand: the standard's distributions may differ between libraries, these bytes may
// not.
double uniform(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

double normal(std::mt19937_64& engine) {
  const double u = std::max(uniform(engine), 1e-300), v = uniform(engine);
  return std::sqrt(-2 * std::log(u)) * std::cos(2 * CV_PI * v);
}

cv::Mat1f white_noise(int side, std::mt19937_64& engine) {
  cv::Mat1f noise(side, side);
  for (float& value : noise) value = static_cast<float>(normal(engine));
  return noise;
}

// Noise of one grain size: blurred, mean 0, deviation 1.
cv::Mat1f grain_of(int side, double sigma_px, std::mt19937_64& engine) {
  cv::Mat1f noise = white_noise(side, engine);
  cv::GaussianBlur(noise, noise, {}, sigma_px, sigma_px, cv::BORDER_REFLECT);
  cv::Scalar mean, deviation;
  cv::meanStdDev(noise, mean, deviation);
  return (noise - mean[0]) / deviation[0];
}

std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

}  // namespace

GranularTexture::GranularTexture(double radius_um, double finest_um, std::uint64_t seed) {
  constexpr double kStep_um = 0.35;
  const int side = std::clamp(static_cast<int>(std::ceil(2 * radius_um / kStep_um)) + 2, 16, 2048);
  const double step_um = 2 * radius_um / (side - 2);
  std::mt19937_64 engine(mix(seed ^ 0x677261696eULL));
  const double fine_px = std::max(0.75, finest_um) / step_um;
  fine_ = 0.75f * grain_of(side, fine_px, engine);
  coarse_ = 0.60f * grain_of(side, 2.5 * fine_px, engine) + 0.45f * grain_of(side, 9.0 / step_um, engine);
  origin_um_ = static_cast<float>(radius_um);
  inverse_step_ = static_cast<float>(1 / step_um);
}

float GranularTexture::at(float x_um, float y_um, float sharpness) const noexcept {
  const float x = (x_um + origin_um_) * inverse_step_, y = (y_um + origin_um_) * inverse_step_;
  if (!(x >= 0 && y >= 0)) return 0.0f;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  if (i + 1 >= fine_.cols || j + 1 >= fine_.rows) return 0.0f;
  const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
  auto bilinear = [&](const cv::Mat1f& grain) {
    const float *top = grain[j] + i, *bottom = grain[j + 1] + i;
    return (1 - v) * (top[0] + u * (top[1] - top[0])) + v * (bottom[0] + u * (bottom[1] - bottom[0]));
  };
  return sharpness * bilinear(fine_) + bilinear(coarse_);
}

NoiseBank::NoiseBank(std::uint64_t seed) : numbers_((1 << 20) + 8192), seed_(mix(seed ^ 0x6e6f697365ULL)) {
  std::mt19937_64 engine(seed_);
  for (std::size_t i = 0; i + 1 < numbers_.size(); i += 2) {
    // Box and Muller's pair.
    const double radius = std::sqrt(-2 * std::log(std::max(uniform(engine), 1e-300))),
                 angle = 2 * CV_PI * uniform(engine);
    numbers_[i] = static_cast<float>(radius * std::cos(angle));
    numbers_[i + 1] = static_cast<float>(radius * std::sin(angle));
  }
}

const float* NoiseBank::row(long frame, int row) const noexcept {
  const std::uint64_t place =
      mix(seed_ ^ mix((static_cast<std::uint64_t>(frame) << 20) ^ static_cast<std::uint64_t>(row)));
  return numbers_.data() + (place & ((1 << 20) - 1));
}

void draw_debris(cv::Mat1f& transmittance, int count, double max_radius_um, double pixel_size_um, std::uint64_t seed) {
  std::mt19937_64 engine(mix(seed ^ 0x646562726973ULL));
  for (int k = 0; k < count; ++k) {
    const double x = uniform(engine) * transmittance.cols, y = uniform(engine) * transmittance.rows;
    const double radius_um = 0.5 + (max_radius_um - 0.5) * uniform(engine), depth = 0.05 + 0.17 * uniform(engine);
    const double blur_um = std::max(0.7, 0.35 * radius_um) + 0.8 * uniform(engine);
    const int reach = static_cast<int>(std::ceil((radius_um + 4 * blur_um) / pixel_size_um));
    for (int j = std::max(0, static_cast<int>(y) - reach);
         j <= std::min(transmittance.rows - 1, static_cast<int>(y) + reach); ++j)
      for (int i = std::max(0, static_cast<int>(x) - reach);
           i <= std::min(transmittance.cols - 1, static_cast<int>(x) + reach); ++i) {
        const double r = pixel_size_um * std::hypot(i - x, j - y);
        const double ring = -depth * gaussian(r - 0.6 * radius_um, blur_um) +
                            0.45 * depth * gaussian(r - radius_um - 1.6 * blur_um, blur_um);
        transmittance(j, i) *= static_cast<float>(1 + ring);
      }
  }
}

}  // namespace pellucida
