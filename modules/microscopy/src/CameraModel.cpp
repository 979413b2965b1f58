#include "CameraModel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

constexpr int kGammaSteps = 4096;

cv::Mat1f make_field(const Look::Camera& look, const cv::Size& size, std::uint64_t seed) {
  cv::Mat1f field(size);
  const double angle = look.gradient_angle_deg * std::numbers::pi / 180, half = std::hypot(size.width, size.height) / 2;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double u = (x - size.width / 2.0) / half, v = (y - size.height / 2.0) / half;
      const double slope = 1 + look.gradient_ratio / 2 * (u * std::cos(angle) + v * std::sin(angle));
      field(y, x) = static_cast<float>(look.level_ratio * slope * (1 - look.vignette_ratio * (u * u + v * v)));
    }
  // Dust lies before the sensor: soft dark discs, some with a bright rim.
  std::mt19937_64 engine(mix(seed ^ 0x64757374ULL));
  for (int k = 0; k < look.dust_count; ++k) {
    const double x = uniform(engine) * size.width, y = uniform(engine) * size.height;
    const double radius = look.dust_radius_px * (0.3 + 0.7 * uniform(engine)), depth = 0.05 + 0.25 * uniform(engine),
                 rim = uniform(engine);
    const int reach = static_cast<int>(2.5 * radius) + 2;
    for (int j = std::max(0, static_cast<int>(y) - reach); j <= std::min(size.height - 1, static_cast<int>(y) + reach);
         ++j)
      for (int i = std::max(0, static_cast<int>(x) - reach); i <= std::min(size.width - 1, static_cast<int>(x) + reach);
           ++i) {
        const double r = std::hypot(i - x, j - y) / radius;
        const double disc = 1 / (1 + std::exp(6 * (r - 1))), ring = std::exp(-12 * (r - 1.25) * (r - 1.25));
        field(j, i) *= static_cast<float>(1 - depth * disc + 0.3 * rim * depth * ring);
      }
  }
  return field;
}

// Pixels and columns that count a little more or less.
cv::Mat1f make_pattern(double spread, const cv::Size& size, std::uint64_t seed) {
  cv::Mat1f pattern(size, 0.0f);
  if (spread <= 0) return pattern;
  std::mt19937_64 engine(mix(seed ^ 0x7061747465726eULL));
  std::vector<double> columns(static_cast<std::size_t>(size.width));
  for (double& column : columns) column = 0.6 * normal(engine);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      pattern(y, x) = static_cast<float>(spread * (columns[static_cast<std::size_t>(x)] + 0.8 * normal(engine)));
  return pattern;
}

}  // namespace

CameraModel::CameraModel(const Look::Camera& look, const ImageView& image, std::uint64_t seed)
    : look_(look),
      noise_(seed),
      field_(make_field(look, {image.width_px, image.height_px}, seed)),
      pattern_(make_pattern(look.fixed_pattern_ratio, {image.width_px, image.height_px}, seed)),
      counted_(static_cast<std::size_t>(image.width_px)),
      frame_(image.height_px, image.width_px, image.format == PixelFormat::kGray16 ? CV_16U : CV_8U) {
  if (look.jpeg_quality > 0 && image.format == PixelFormat::kGray16)
    throw UsageError("camera.jpeg_quality is set; JPEG needs a picture of 8 bit");
  for (int i = 0; i <= kGammaSteps; ++i)
    gamma_.push_back(static_cast<float>(std::pow(static_cast<double>(i) / kGammaSteps, look.gamma)));
  // The level is what the picture shows: gamma is undone for it.
  field_ *= std::pow(look.level_ratio, 1 / look.gamma) / look.level_ratio;
}

template <class Pixel>
void CameraModel::count(const cv::Mat1f& light, long frame_index, float lamp) {
  constexpr float kFull = std::numeric_limits<Pixel>::max();
  const auto shot = static_cast<float>(1 / look_.full_well_electrons);
  const auto read = static_cast<float>(std::pow(look_.read_noise_electrons / look_.full_well_electrons, 2));
  float* const counted = counted_.data();
  const bool curved = look_.gamma != 1.0;
  for (int y = 0; y < light.rows; ++y) {
    const float *row = light[y], *field = field_[y], *fixed = pattern_[y], *noise = noise_.row(frame_index, y);
    for (int x = 0; x < light.cols; ++x) {
      const float lit = lamp * row[x] * field[x], positive = lit > 0.0f ? lit : 0.0f;
      const float value = lit + noise[x] * std::sqrt(positive * shot + read) + fixed[x];
      const float above = value > 0.0f ? value : 0.0f;
      counted[x] = above < 1.0f ? above : 1.0f;
    }
    if (curved)
      for (int x = 0; x < light.cols; ++x)
        counted[x] = gamma_[static_cast<std::size_t>(counted[x] * static_cast<float>(kGammaSteps) + 0.5f)];
    auto* pixel = frame_.ptr<Pixel>(y);
    for (int x = 0; x < light.cols; ++x) pixel[x] = static_cast<Pixel>(static_cast<int>(counted[x] * kFull + 0.5f));
  }
}

const cv::Mat& CameraModel::expose(const cv::Mat1f& light, long frame_index, double time_s, double lamp_ratio) {
  const bool stepped = std::fmod(std::floor(time_s / look_.exposure_period_s + 1e-9), 2.0) == 1.0;
  const auto lamp = static_cast<float>(lamp_ratio * (stepped ? 1 + look_.exposure_step_ratio : 1.0));
  if (frame_.depth() == CV_16U)
    count<std::uint16_t>(light, frame_index, lamp);
  else
    count<std::uint8_t>(light, frame_index, lamp);

  if (look_.interlaced) {
    // Every other row is older.
    const bool has_before = !before_.empty();
    cv::Mat now = frame_.clone();
    if (has_before)
      for (int y = 1; y < frame_.rows; y += 2) before_.row(y).copyTo(frame_.row(y));
    before_ = now;
  }
  if (look_.sharpening_ratio > 0) {
    cv::GaussianBlur(frame_, soft_, {}, 1.2, 1.2, cv::BORDER_REPLICATE);
    cv::addWeighted(frame_, 1 + look_.sharpening_ratio, soft_, -look_.sharpening_ratio, 0, frame_);
  }
  if (look_.jpeg_quality > 0) {
    cv::imencode(".jpg", frame_, jpeg_, {cv::IMWRITE_JPEG_QUALITY, look_.jpeg_quality});
    cv::imdecode(jpeg_, cv::IMREAD_GRAYSCALE, &frame_);
  }
  return frame_;
}

}  // namespace pellucida
