#include "Texture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "EdgeProfile.h"
#include "pellucida/microscopy/SeededNumbers.h"

namespace pellucida {
namespace {

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

}  // namespace

std::vector<Granule> make_granules(double disc_radius_um, double finest_sigma_um, std::uint64_t seed) {
  std::mt19937_64 engine(mix(seed ^ 0x6772616e756c65ULL));
  std::vector<Granule> granules;
  // Blobs of strength a, sigma s, and density n a um^2 add up to a deviation of a s sqrt(pi n).
  auto population = [&](double per_um2, double sigma_um, double deviation) {
    const double strength = deviation / (sigma_um * std::sqrt(CV_PI * per_um2));
    const long count = std::lround(per_um2 * CV_PI * disc_radius_um * disc_radius_um);
    for (long k = 0; k < count; ++k) {
      const double ratio = std::sqrt(uniform(engine)), angle = 2 * CV_PI * uniform(engine);
      const double size = sigma_um * (0.75 + 0.5 * uniform(engine)), light = strength * normal(engine);
      granules.push_back(
          {static_cast<float>(ratio), static_cast<float>(angle), static_cast<float>(size), static_cast<float>(light)});
    }
  };
  population(0.45, std::max(0.75, finest_sigma_um), 0.75);
  population(0.05, std::max(1.9, finest_sigma_um), 0.50);
  return granules;
}

void draw_granule(cv::Mat1f& grain, float x_px, float y_px, float sigma_px, float strength) noexcept {
  // A Gaussian is a product of one across and one down.
  constexpr int kMost = 64;
  const int reach = std::min(kMost / 2 - 1, static_cast<int>(std::ceil(3 * sigma_px)));
  const int x0 = static_cast<int>(std::floor(x_px)) - reach, y0 = static_cast<int>(std::floor(y_px)) - reach;
  const int count = 2 * reach + 2;
  float across[kMost], down[kMost];
  const float scale = -0.5f / (sigma_px * sigma_px);
  for (int k = 0; k < count; ++k) {
    const float dx = static_cast<float>(x0 + k) - x_px, dy = static_cast<float>(y0 + k) - y_px;
    across[k] = std::exp(scale * dx * dx);
    down[k] = strength * std::exp(scale * dy * dy);
  }
  const int first = std::max(0, -x0), last = std::min(count, grain.cols - x0);
  for (int j = std::max(0, -y0); j < std::min(count, grain.rows - y0); ++j) {
    float* row = grain[y0 + j] + x0;
    for (int i = first; i < last; ++i) row[i] += across[i] * down[j];
  }
}

Mottling::Mottling(double radius_um, std::uint64_t seed) {
  constexpr double kGrain_um = 7.0, kStep_um = 1.0;
  const int side = std::clamp(static_cast<int>(std::ceil(2 * radius_um / kStep_um)) + 2, 16, 2048);
  const double step_um = 2 * radius_um / (side - 2);
  std::mt19937_64 engine(mix(seed ^ 0x6d6f74746c65ULL));
  cloud_ = grain_of(side, kGrain_um / step_um, engine);
  origin_um_ = static_cast<float>(radius_um);
  inverse_step_ = static_cast<float>(1 / step_um);
}

float Mottling::at(float x_um, float y_um) const noexcept {
  const float x = (x_um + origin_um_) * inverse_step_, y = (y_um + origin_um_) * inverse_step_;
  if (!(x >= 0 && y >= 0)) return 0.0f;
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  if (i + 1 >= cloud_.cols || j + 1 >= cloud_.rows) return 0.0f;
  const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
  const float *top = cloud_[j] + i, *bottom = cloud_[j + 1] + i;
  return (1 - v) * (top[0] + u * (top[1] - top[0])) + v * (bottom[0] + u * (bottom[1] - bottom[0]));
}

void draw_particle(cv::Mat1f& transmittance, double x, double y, const Particle& particle, double pixel_size_um) {
  const auto [radius_um, depth, blur_um] = particle;
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

void draw_debris(cv::Mat1f& transmittance, int count, double max_radius_um, double pixel_size_um, std::uint64_t seed) {
  std::mt19937_64 engine(mix(seed ^ 0x646562726973ULL));
  for (int k = 0; k < count; ++k) {
    const double x = uniform(engine) * transmittance.cols, y = uniform(engine) * transmittance.rows;
    const double radius_um = 0.5 + (max_radius_um - 0.5) * uniform(engine), depth = 0.05 + 0.17 * uniform(engine);
    const double blur_um = std::max(0.7, 0.35 * radius_um) + 0.8 * uniform(engine);
    draw_particle(transmittance, x, y, {radius_um, depth, blur_um}, pixel_size_um);
  }
}

std::vector<PassingParticle> make_passing_particles(int count, double max_radius_um, std::uint64_t seed) {
  std::mt19937_64 engine(mix(seed ^ 0x70617373696e67ULL));
  std::vector<PassingParticle> particles;
  for (int k = 0; k < count; ++k) {
    PassingParticle p{};
    p.particle.radius_um = 0.5 + (max_radius_um - 0.5) * (0.5 + 0.5 * uniform(engine));
    p.particle.depth = 0.12 + 0.15 * uniform(engine);
    p.particle.blur_um = std::max(0.7, 0.35 * p.particle.radius_um);
    p.x_ratio = uniform(engine);
    p.y_ratio = uniform(engine);
    p.angle_rad = 2 * CV_PI * uniform(engine);
    particles.push_back(p);
  }
  return particles;
}

std::vector<double> make_touching_angles(int count, double holder_angle_rad, std::uint64_t seed) {
  // The holder lies in the direction (sin, -cos) of (across, axis): at pi - its angle from the apex.
  constexpr double kClear_rad = 0.5;
  const double holder_rad = CV_PI - holder_angle_rad;
  std::mt19937_64 engine(mix(seed ^ 0x746f756368ULL));
  std::vector<double> angles;
  while (static_cast<int>(angles.size()) < count) {
    const double angle = CV_PI * (2 * uniform(engine) - 1);
    const bool at_needle = std::abs(angle) < kClear_rad;
    const bool at_holder = std::abs(std::remainder(angle - holder_rad, 2 * CV_PI)) < kClear_rad;
    if (!at_needle && !at_holder) angles.push_back(angle);
  }
  return angles;
}

Eigen::Vector2d passing_place_px(const PassingParticle& particle, const Scenario::Debris& debris, double time_s,
                                 const cv::Size& size, double pixel_size_um) {
  // The field has a margin, so that particles come in from outside the picture.
  const double margin_um = 4 * debris.max_radius_um + 10, way_um = debris.passing_speed_um_per_s * time_s;
  auto along = [&](double ratio, double direction, int size_px) {
    const double length = size_px * pixel_size_um + 2 * margin_um, at = ratio * length + way_um * direction;
    return (at - length * std::floor(at / length) - margin_um) / pixel_size_um;
  };
  return {along(particle.x_ratio, std::cos(particle.angle_rad), size.width),
          along(particle.y_ratio, std::sin(particle.angle_rad), size.height)};
}

Eigen::Vector2d touching_place_um(const Contour_um& outer_um, const Eigen::VectorXd& angle_rad, double at_rad,
                                  double radius_um) {
  const Eigen::Index n = outer_um.cols();
  const auto* first = angle_rad.data();
  const Eigen::Index k = std::min<Eigen::Index>(std::lower_bound(first, first + n, at_rad) - first, n - 1);
  // Outwards is left of the way round.
  const Eigen::Vector2d tangent = (outer_um.col((k + 1) % n) - outer_um.col((k + n - 1) % n)).normalized();
  return outer_um.col(k) + 0.8 * radius_um * Eigen::Vector2d(-tangent.y(), tangent.x());
}

}  // namespace pellucida
