#include "Optics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "Texture.h"

namespace pellucida {
namespace {

// Narrowest line that the pixels can carry, um.
double line_sigma(const Scenario& s, double wanted_um) {
  return std::max(wanted_um, 0.5 * s.image.pixel_size_um);
}

}  // namespace

EdgeProfile make_outer_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.80);
  return {[=](double d) {
            return 1 - 0.40 * c * gaussian(d, sigma) + 0.10 * h * gaussian(d - 2.7, 1.1) +
                   0.05 * h * gaussian(d + 2.0, 0.8) + 0.035 * c * soft_step(-d - 0.8, 0.6);
          },
          kBand_um, sigma, true};
}

// The zona's inner edge. Without a gap the ooplasm follows at once and darkens the inside.
EdgeProfile make_inner_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.80);
  const bool gap = s.cell.perivitelline_gap_um > 0;
  const double depth = gap ? 0.28 : 0.42, inside = gap ? -0.03 : -0.25;
  return {[=](double d) {
            return 1 - depth * c * gaussian(d, sigma) + 0.06 * h * gaussian(d - 2.0, 0.7) +
                   0.07 * h * gaussian(d + 2.4, 1.0) + inside * c * soft_step(-d - 1.6, 0.7);
          },
          kBand_um, sigma, true};
}

EdgeProfile make_ooplasm_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.85);
  return {[=](double d) {
            return 1 - 0.40 * c * gaussian(d, sigma) + 0.10 * h * gaussian(d - 2.3, 0.9) +
                   0.06 * h * gaussian(d + 2.4, 1.0) - 0.25 * c * soft_step(-d - 1.6, 0.7);
          },
          kBand_um, sigma, true};
}

// Thick glass: broad dark edges, a bright core.
EdgeProfile make_holder_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 1.25);
  return {[=](double d) {
            return 1 - 0.58 * c * gaussian(d + 0.4, sigma) + 0.12 * h * gaussian(d - 3.0, 1.4) +
                   0.34 * h * soft_step(-d - 3.0, 0.8);
          },
          kBand_um, sigma, false};
}

EdgeProfile make_needle_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo;
  const double sharp = line_sigma(s, 0.70), sigma = std::hypot(sharp, s.optics.needle_defocus_um);
  const double fade = sharp / sigma;  // a blurred line is as dark in sum
  return {[=](double d) {
            return 1 - 0.52 * c * fade * gaussian(d, sigma) + 0.10 * h * fade * gaussian(d - 2.4 * sigma, 1.1 * sigma) +
                   0.14 * h * fade * soft_step(-d - 1.7 * sigma, 0.6 * sigma);
          },
          std::max(kBand_um, 6 * sigma), sigma, true};
}

EdgeProfile make_bubble_edge(const Scenario& s, double radius_um) {
  const double c = s.optics.contrast, h = c * s.optics.halo, ring = std::max(line_sigma(s, 1.0), 0.12 * radius_um);
  return {[=](double d) {
            return 1 - 0.75 * c * gaussian(d + 1.2 * ring, ring) + 0.15 * h * gaussian(d - 1.5 * ring, 0.6 * ring) +
                   0.20 * h * soft_step(-d - 3.5 * ring, ring);
          },
          std::max(kBand_um, 7 * ring), ring, false};
}

EdgeProfile make_droplet_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, rim = line_sigma(s, 0.7);
  return {[=](double d) {
            return 1 - 0.35 * c * gaussian(d, rim) + 0.08 * h * gaussian(d - 2.0, 0.8) +
                   0.30 * h * soft_step(-d - 1.5, 0.6);
          },
          kBand_um, rim, false};
}

EdgeProfile make_inside_weight() {
  return {[](double d) { return soft_step(-d - 1.8, 0.8); }, kBand_um, 1.0, false};
}

// Illumination: a slope from side to side, darker corners, and the debris that lies on the glass.
cv::Mat1f make_field_of_light(const Scenario& s) {
  const auto& image = s.image;
  cv::Mat1f debris(image.height_px, image.width_px, 1.0f);
  draw_debris(debris, s.debris.count, s.debris.max_radius_um, image.pixel_size_um, s.seed);
  cv::Mat1f field(image.height_px, image.width_px);
  const double angle = s.optics.gradient_angle_deg * std::numbers::pi / 180,
               half = std::hypot(image.width_px, image.height_px) / 2;
  for (int y = 0; y < field.rows; ++y)
    for (int x = 0; x < field.cols; ++x) {
      const double u = (x - field.cols / 2.0) / half, v = (y - field.rows / 2.0) / half;
      const double slope = 1 - s.optics.gradient_ratio / 2 * (u * std::cos(angle) + v * std::sin(angle));
      const double corners = 1 - s.optics.vignette_ratio * (u * u + v * v);
      field(y, x) = static_cast<float>(s.optics.background_ratio * slope * corners) * debris(y, x);
    }
  return field;
}

}  // namespace pellucida
