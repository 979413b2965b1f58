#include "LevelSetOutline.h"

#include <itkGeodesicActiveContourLevelSetImageFilter.h>
#include <itkImage.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ContourMath.h"

namespace pellucida {
namespace {

using Field = itk::Image<float, 2>;

// The reduced region of interest: pixel (x, y) lies at corner + scale (x, y) of the image.
struct Region {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  double scale = 1.0;
  int width = 0, height = 0;

  Eigen::Vector2d image_of(double x, double y) const { return corner + scale * Eigen::Vector2d(x, y); }
};

Region region_round(const Eigen::Matrix2Xd& outline, double radius, const LevelSetSettings& settings) {
  Region region;
  region.scale = std::max(1.0, radius / settings.radius_px);
  const double margin = settings.margin_ratio * radius;
  region.corner = outline.rowwise().minCoeff().array() - margin;
  const Eigen::Vector2d size = (outline.rowwise().maxCoeff() - outline.rowwise().minCoeff()).array() + 2.0 * margin;
  region.width = std::max(8, static_cast<int>(std::ceil(size.x() / region.scale)));
  region.height = std::max(8, static_cast<int>(std::ceil(size.y() / region.scale)));
  return region;
}

Field::Pointer make_field(const Region& region) {
  Field::SizeType size;
  size[0] = static_cast<itk::SizeValueType>(region.width);
  size[1] = static_cast<itk::SizeValueType>(region.height);
  const auto field = Field::New();
  field->SetRegions(Field::RegionType(size));
  field->Allocate();
  return field;
}

// g of the header, from a copy of the region blurred in steps of a reduced pixel.
Field::Pointer edge_speed(const GrayImage& image, const Region& region) {
  const int w = region.width, h = region.height;
  std::vector<float> grey(static_cast<std::size_t>(w) * h), blurred(grey.size());
  const auto at = [&](std::vector<float>& field, int x, int y) -> float& {
    return field[static_cast<std::size_t>(std::clamp(y, 0, h - 1)) * w + std::clamp(x, 0, w - 1)];
  };
  // A reduced pixel is the mean of what it covers.
  const int samples = std::max(1, static_cast<int>(std::ceil(region.scale)));
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      float sum = 0.0F;
      for (int v = 0; v < samples; ++v)
        for (int u = 0; u < samples; ++u)
          sum += image.sample(region.image_of(x + (u + 0.5) / samples - 0.5, y + (v + 0.5) / samples - 0.5));
      at(grey, x, y) = sum / static_cast<float>(samples * samples);
    }
  }
  // Two passes of (1 2 1) / 4 along each axis: standard deviation 1.
  for (int round = 0; round < 2; ++round) {
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        at(blurred, x, y) = 0.25F * (at(grey, x - 1, y) + 2.0F * at(grey, x, y) + at(grey, x + 1, y));
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        at(grey, x, y) = 0.25F * (at(blurred, x, y - 1) + 2.0F * at(blurred, x, y) + at(blurred, x, y + 1));
  }
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      at(blurred, x, y) =
          0.5F * std::hypot(at(grey, x + 1, y) - at(grey, x - 1, y), at(grey, x, y + 1) - at(grey, x, y - 1));
  std::vector<float> sorted = blurred;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const float k = std::max(2.0F * sorted[sorted.size() / 2], 1e-5F);
  const Field::Pointer speed = make_field(region);
  float* out = speed->GetBufferPointer();
  for (std::size_t i = 0; i < blurred.size(); ++i) out[i] = 1.0F / (1.0F + blurred[i] * blurred[i] / (k * k));
  return speed;
}

// Signed distance to the outline in reduced pixels, negative inside.
Field::Pointer signed_distance(const Eigen::Matrix2Xd& outline, const Region& region) {
  const Field::Pointer field = make_field(region);
  float* out = field->GetBufferPointer();
  for (int y = 0; y < region.height; ++y) {
    for (int x = 0; x < region.width; ++x) {
      const Eigen::Vector2d p = region.image_of(x, y);
      const double distance = contour::distance_to(outline, p) / region.scale;
      *out++ = static_cast<float>(contour::contains(outline, p) ? -distance : distance);
    }
  }
  return field;
}

// Where rays from the centre of the inside leave it.
std::optional<Eigen::Matrix2Xd> outline_of(const float* phi, const Region& region) {
  constexpr int kRays = 128;
  const auto at = [&](int x, int y) { return phi[static_cast<std::size_t>(y) * region.width + x]; };
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double count = 0.0;
  for (int y = 0; y < region.height; ++y) {
    for (int x = 0; x < region.width; ++x) {
      if (at(x, y) >= 0.0F) continue;
      sum += Eigen::Vector2d(x, y);
      count += 1.0;
    }
  }
  if (count < 30.0) return std::nullopt;
  const Eigen::Vector2d center = sum / count;
  const auto value = [&](const Eigen::Vector2d& p) {
    const int x = std::clamp(static_cast<int>(p.x()), 0, region.width - 2);
    const int y = std::clamp(static_cast<int>(p.y()), 0, region.height - 2);
    const double tx = p.x() - x, ty = p.y() - y;
    return (1.0 - ty) * ((1.0 - tx) * at(x, y) + tx * at(x + 1, y)) +
           ty * ((1.0 - tx) * at(x, y + 1) + tx * at(x + 1, y + 1));
  };
  if (value(center) >= 0.0) return std::nullopt;
  Eigen::Matrix2Xd outline(2, kRays);
  int at_border = 0;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRays;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    constexpr double kStep = 0.25;
    double radius = 0.0, before = value(center);
    for (;;) {
      const Eigen::Vector2d p = center + (radius + kStep) * direction;
      if (p.x() < 1.0 || p.y() < 1.0 || p.x() > region.width - 2.0 || p.y() > region.height - 2.0) {
        ++at_border;
        break;
      }
      const double now = value(p);
      if (now >= 0.0) {
        radius += kStep * before / (before - now);
        break;
      }
      radius += kStep;
      before = now;
    }
    const Eigen::Vector2d p = center + radius * direction;
    outline.col(i) = region.image_of(p.x(), p.y());
  }
  if (at_border > kRays / 4) return std::nullopt;
  return outline;
}

}  // namespace

std::optional<Eigen::Matrix2Xd> refine_by_level_set(const GrayImage& image, const Eigen::Matrix2Xd& outline,
                                                    const LevelSetSettings& settings) {
  if (outline.cols() < 3) return std::nullopt;
  const double radius = std::sqrt(std::abs(contour::signed_area(outline)) / std::numbers::pi);
  if (!(radius >= 3.0)) return std::nullopt;
  const Region region = region_round(outline, radius, settings);

  using Filter = itk::GeodesicActiveContourLevelSetImageFilter<Field, Field>;
  const auto filter = Filter::New();
  filter->SetInput(signed_distance(outline, region));
  filter->SetFeatureImage(edge_speed(image, region));
  filter->SetPropagationScaling(settings.propagation);
  filter->SetCurvatureScaling(settings.curvature);
  filter->SetAdvectionScaling(settings.advection);
  filter->SetMaximumRMSError(0.01);
  filter->SetNumberOfIterations(static_cast<itk::IdentifierType>(std::max(settings.iterations, 1)));
  filter->SetNumberOfWorkUnits(1);
  filter->Update();
  return outline_of(filter->GetOutput()->GetBufferPointer(), region);
}

}  // namespace pellucida
