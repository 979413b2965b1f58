#include "Renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "DistanceField.h"

namespace pellucida {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kBand_um = 9.0;
constexpr int kDirectionCount = 2048;

// Narrowest line that the pixels can carry, um.
double line_sigma(const Scenario& s, double wanted_um) {
  return std::max(wanted_um, 0.5 * s.image.pixel_size_um);
}

EdgeProfile outer_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.80);
  return {[=](double d) {
            return 1 - 0.40 * c * gaussian(d, sigma) + 0.10 * h * gaussian(d - 2.7, 1.1) +
                   0.05 * h * gaussian(d + 2.0, 0.8) + 0.035 * c * soft_step(-d - 0.8, 0.6);
          },
          kBand_um, sigma, true};
}

// The zona's inner edge. Without a gap the ooplasm follows at once and darkens the inside.
EdgeProfile inner_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.80);
  const bool gap = s.cell.perivitelline_gap_um > 0;
  const double depth = gap ? 0.28 : 0.42, inside = gap ? -0.03 : -0.25;
  return {[=](double d) {
            return 1 - depth * c * gaussian(d, sigma) + 0.06 * h * gaussian(d - 2.0, 0.7) +
                   0.07 * h * gaussian(d + 2.4, 1.0) + inside * c * soft_step(-d - 1.6, 0.7);
          },
          kBand_um, sigma, true};
}

EdgeProfile ooplasm_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 0.85);
  return {[=](double d) {
            return 1 - 0.40 * c * gaussian(d, sigma) + 0.10 * h * gaussian(d - 2.3, 0.9) +
                   0.06 * h * gaussian(d + 2.4, 1.0) - 0.25 * c * soft_step(-d - 1.6, 0.7);
          },
          kBand_um, sigma, true};
}

// Thick glass: broad dark edges, a bright core.
EdgeProfile holder_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo, sigma = line_sigma(s, 1.25);
  return {[=](double d) {
            return 1 - 0.58 * c * gaussian(d + 0.4, sigma) + 0.12 * h * gaussian(d - 3.0, 1.4) +
                   0.34 * h * soft_step(-d - 3.0, 0.8);
          },
          kBand_um, sigma, false};
}

EdgeProfile needle_edge(const Scenario& s) {
  const double c = s.optics.contrast, h = c * s.optics.halo;
  const double sharp = line_sigma(s, 0.70), sigma = std::hypot(sharp, s.optics.needle_defocus_um);
  const double fade = sharp / sigma;  // a blurred line is as dark in sum
  return {[=](double d) {
            return 1 - 0.52 * c * fade * gaussian(d, sigma) + 0.10 * h * fade * gaussian(d - 2.4 * sigma, 1.1 * sigma) +
                   0.14 * h * fade * soft_step(-d - 1.7 * sigma, 0.6 * sigma);
          },
          std::max(kBand_um, 6 * sigma), sigma, true};
}

EdgeProfile inside_weight() {
  return {[](double d) { return soft_step(-d - 1.8, 0.8); }, kBand_um, 1.0, false};
}

// Columns [first, last] of a row whose lateral distance to an axis is at most `reach`, and whose place along it is at
// least `begin`; all lengths in px. `point` relative to the axis's origin: (x - ox, y - oy).
struct Strip {
  Eigen::Vector2d origin, along, across;
  double reach, begin;

  bool columns(int y, int width, int& first, int& last) const {
    double low = 0, high = width - 1;
    // A bound a * x + b in [min, max].
    auto cut = [&](double a, double b, double min, double max) {
      if (std::abs(a) < 1e-9) {
        if (b < min || b > max) high = -1;
        return;
      }
      double x0 = (min - b) / a, x1 = (max - b) / a;
      if (x0 > x1) std::swap(x0, x1);
      low = std::max(low, x0);
      high = std::min(high, x1);
    };
    const double dy = y - origin.y();
    cut(across.x(), dy * across.y() - origin.x() * across.x(), -reach, reach);
    cut(along.x(), dy * along.y() - origin.x() * along.x(), begin, 1e9);
    first = static_cast<int>(std::ceil(low));
    last = static_cast<int>(std::floor(high));
    return first <= last;
  }
};

// Illumination: a slope from side to side, darker corners, and the debris that lies on the glass.
cv::Mat1f field_of_light(const Scenario& s) {
  const auto& image = s.image;
  cv::Mat1f debris(image.height_px, image.width_px, 1.0f);
  draw_debris(debris, s.debris.count, s.debris.max_radius_um, image.pixel_size_um, s.seed);
  cv::Mat1f field(image.height_px, image.width_px);
  const double angle = s.optics.gradient_angle_deg * kPi / 180, half = std::hypot(image.width_px, image.height_px) / 2;
  for (int y = 0; y < field.rows; ++y)
    for (int x = 0; x < field.cols; ++x) {
      const double u = (x - field.cols / 2.0) / half, v = (y - field.rows / 2.0) / half;
      const double slope = 1 - s.optics.gradient_ratio / 2 * (u * std::cos(angle) + v * std::sin(angle));
      const double corners = 1 - s.optics.vignette_ratio * (u * u + v * v);
      field(y, x) = static_cast<float>(s.optics.background_ratio * slope * corners) * debris(y, x);
    }
  return field;
}

}  // namespace

Renderer::Renderer(const Scenario& scenario, const VirtualSpecimen& specimen)
    : scenario_(scenario),
      rim_(holder_rim(specimen)),
      rest_pose_(specimen.pose()),
      material_angle_rad_(specimen.reference().angle_rad()),
      inner_radius_um_(specimen.inner_radius_um()),
      outer_edge_(outer_edge(scenario)),
      inner_edge_(inner_edge(scenario)),
      ooplasm_edge_(ooplasm_edge(scenario)),
      ooplasm_weight_(inside_weight()),
      holder_edge_(holder_edge(scenario)),
      needle_edge_(needle_edge(scenario)),
      texture_(1.05 * specimen.outer_radius_um(), 0.6 * scenario.image.pixel_size_um, scenario.seed),
      noise_(scenario.seed),
      background_(field_of_light(scenario)),
      frame_(scenario.image.height_px, scenario.image.width_px, scenario.image.bit_depth == 16 ? CV_16U : CV_8U),
      polar_map_(kDirectionCount) {}

const cv::Mat& Renderer::render(const Truth& truth, const SpecimenState& state) {
  background_.copyTo(light_);
  draw_cell(truth, state);
  draw_holder(*truth.observation.holder, truth.observation.center_um);
  draw_needle(*truth.observation.needle);
  if (scenario_.optics.defocus_um > 0)
    cv::GaussianBlur(light_, light_, {}, scenario_.optics.defocus_um / scenario_.image.pixel_size_um, 0,
                     cv::BORDER_REPLICATE);
  if (scenario_.image.bit_depth == 16)
    count_light<std::uint16_t>(truth.observation.frame_index);
  else
    count_light<std::uint8_t>(truth.observation.frame_index);
  return frame_;
}

void Renderer::fill_polar_map(const SpecimenState& state) {
  // The centre: across, the area's centroid; along the axis, midway between the dimple and the far side, so that the
  // material before the needle is squeezed no more than need be. Every part of the boundary is seen from it.
  const Contour_um& boundary = state.section.inner_um;
  const Eigen::Index n = boundary.cols();
  double area = 0, moment = 0;
  for (Eigen::Index i = 0, j = n - 1; i < n; j = i++) {
    const double cross = boundary(0, j) * boundary(1, i) - boundary(0, i) * boundary(1, j);
    area += cross / 2;
    moment += cross / 6 * (boundary(0, j) + boundary(0, i));
  }
  polar_center_ = {moment / area, (boundary(1, n / 2) + boundary.row(1).minCoeff()) / 2};

  // Each piece of the boundary fills the directions it spans. Directions: atan2(x, z), as the material angle.
  auto direction_of = [&](Eigen::Index i) {
    const Eigen::Vector2d from = boundary.col(i % n) - polar_center_;
    return std::pair(std::atan2(from.x(), from.y()), from.norm());
  };
  auto [angle0, radius0] = direction_of(0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto [angle1, radius1] = direction_of(i + 1);
    double turn = angle1 - angle0;
    turn -= 2 * kPi * std::round(turn / (2 * kPi));
    const double material0 = material_angle_rad_(i);
    const double material1 = i + 1 < n ? material_angle_rad_(i + 1) : material_angle_rad_(0) + 2 * kPi;
    const int first = static_cast<int>(std::ceil((angle0 + kPi) / (2 * kPi) * kDirectionCount));
    const int last = static_cast<int>(std::floor((angle0 + turn + kPi) / (2 * kPi) * kDirectionCount));
    for (int k = first; k <= last; ++k) {
      const double part = (2 * kPi * k / kDirectionCount - kPi - angle0) / turn;
      const double material = material0 + part * (material1 - material0);
      polar_map_[static_cast<std::size_t>((k % kDirectionCount + kDirectionCount) % kDirectionCount)] = {
          0.0f, static_cast<float>(material), static_cast<float>(1 / (radius0 + part * (radius1 - radius0)))};
    }
    angle0 = angle1;
    radius0 = radius1;
  }

  // Deep inside, equal areas: the angle at rest grows with the sector's area. It begins at the apex, where both agree.
  double whole = 0;
  for (const auto& direction : polar_map_) whole += 1 / (direction.inverse_radius * direction.inverse_radius);
  constexpr int kApex = kDirectionCount / 2;
  double sector = 0;
  for (int step = 0; step < kDirectionCount; ++step) {
    Direction& direction = polar_map_[static_cast<std::size_t>((kApex + step) % kDirectionCount)];
    const double share = 1 / (direction.inverse_radius * direction.inverse_radius) / whole;
    const double turned = std::remainder(direction.boundary_turn - 2 * kPi * (sector + share / 2), 2 * kPi);
    direction.angle = static_cast<float>(2 * kPi * (sector + share / 2));
    direction.boundary_turn = static_cast<float>(turned);
    sector += share;
  }
}

void Renderer::draw_cell(const Truth& truth, const SpecimenState& state) {
  const Observation& seen = truth.observation;
  const double pixel_um = scenario_.image.pixel_size_um;

  // Only the window about the cell is drawn.
  const auto& outer = seen.outer->points_um;
  const Eigen::Vector2d low = (outer.rowwise().minCoeff().array() - kBand_um) / pixel_um;
  const Eigen::Vector2d high = (outer.rowwise().maxCoeff().array() + kBand_um) / pixel_um;
  const cv::Rect window =
      cv::Rect(cv::Point(static_cast<int>(std::floor(low.x())), static_cast<int>(std::floor(low.y()))),
               cv::Point(static_cast<int>(std::ceil(high.x())) + 1, static_cast<int>(std::ceil(high.y())) + 1)) &
      cv::Rect({}, light_.size());
  if (window.empty()) return;
  signed_distance(outer, pixel_um, window, kBand_um, outer_distance_um_);
  signed_distance(seen.inner->points_um, pixel_um, window, kBand_um, inner_distance_um_);
  if (seen.oolemma) signed_distance(seen.oolemma->points_um, pixel_um, window, kBand_um, ooplasm_distance_um_);
  fill_polar_map(state);

  // Pixel to section frame, relative to the map's centre.
  const Eigen::Vector2d across = rest_pose_.across, axis = rest_pose_.axis;
  const Eigen::Vector2d map_center = seen.center_um + polar_center_.x() * across + polar_center_.y() * axis;
  // The side the light seems to come from; fixed in the image.
  const Eigen::Vector2d lit(std::cos(-kPi / 4), std::sin(-kPi / 4));
  const auto lit_across = static_cast<float>(lit.dot(across)), lit_axis = static_cast<float>(lit.dot(axis));

  const auto contrast = static_cast<float>(scenario_.optics.contrast),
             relief = static_cast<float>(scenario_.optics.relief);
  const float grain = 0.075f * contrast * static_cast<float>(scenario_.optics.granularity), zona_grain = 0.15f * grain;
  const auto radius_um = static_cast<float>(inner_radius_um_);
  for (int y = 0; y < window.height; ++y) {
    float* light = light_[window.y + y] + window.x;
    const float *outer_d = outer_distance_um_[y], *inner_d = inner_distance_um_[y];
    const float* ooplasm_d = seen.oolemma ? ooplasm_distance_um_[y] : inner_d;
    for (int x = 0; x < window.width; ++x) {
      if (outer_d[x] >= static_cast<float>(kBand_um)) continue;

      // Which material lies here: its direction at rest and its part of the way from the centre.
      const double from_x = (window.x + x) * pixel_um - map_center.x(),
                   from_y = (window.y + y) * pixel_um - map_center.y();
      const auto u = static_cast<float>(from_x * across.x() + from_y * across.y());
      const auto v = static_cast<float>(from_x * axis.x() + from_y * axis.y());
      const float turns =
          (std::atan2(u, v) + static_cast<float>(kPi)) * static_cast<float>(kDirectionCount / (2 * kPi));
      const auto& direction = polar_map_[static_cast<std::size_t>(turns) & (kDirectionCount - 1)];
      const float ratio = std::sqrt(u * u + v * v) * direction.inverse_radius;
      const float ratio2 = std::min(1.0f, ratio * ratio),
                  angle = direction.angle + direction.boundary_turn * ratio2 * ratio2;
      const float sine = std::sin(angle), cosine = std::cos(angle);
      const float facing = sine * lit_across + cosine * lit_axis;

      // Edges: uneven along the membrane, fringes brighter on the lit side. Neither moves a dark line.
      const float uneven = 1.0f + 0.07f * texture_.at(radius_um * sine, radius_um * cosine, 0.0f);
      const float fringe = uneven * (1.0f + 0.7f * relief * facing);
      auto shade = [&](float through) { return 1.0f + (through - 1.0f) * (through > 1.0f ? fringe : uneven); };
      float through = shade(outer_edge_(outer_d[x])) * shade(inner_edge_(inner_d[x]));
      if (seen.oolemma) through *= shade(ooplasm_edge_(ooplasm_d[x]));

      // Grain and one-sided shading of what lies inside.
      if (outer_d[x] < 0) {
        const float sharpness = std::min(1.0f, 2.0f / (radius_um * direction.inverse_radius) - 0.75f);
        const float inside = ooplasm_weight_(ooplasm_d[x]);
        const float grained =
            texture_.at(ratio * radius_um * sine, ratio * radius_um * cosine, std::max(0.0f, sharpness));
        const float sloped = facing * ratio * (0.07f + 0.15f * ratio * ratio * ratio);
        through *= 1.0f + grained * (zona_grain + (grain - zona_grain) * inside) + contrast * relief * inside * sloped;
      }
      light[x] *= through;
    }
  }
}

void Renderer::draw_holder(const HolderPose& holder, const Eigen::Vector2d& center_um) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const Eigen::Vector2d along = holder.direction, across(-along.y(), along.x());
  Strip strip{(center_um + rim_.distance_um * along) / pixel_um, along, across,
              (rim_.ring_radius_um + rim_.wall_radius_um + kBand_um) / pixel_um,
              -(rim_.wall_radius_um + kBand_um) / pixel_um};
  const auto ring = static_cast<float>(rim_.ring_radius_um), wall = static_cast<float>(rim_.wall_radius_um);
  for (int y = 0, first, last; y < light_.rows; ++y) {
    if (!strip.columns(y, light_.cols, first, last)) continue;
    float* light = light_[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d from = pixel_um * (Eigen::Vector2d(x, y) - strip.origin);
      // Distance to the middle line of the nearer wall, which begins at the rim.
      const auto back = static_cast<float>(from.dot(along));
      const float side = std::abs(static_cast<float>(from.dot(across))) - ring;
      const float middle = back >= 0 ? std::abs(side) : std::sqrt(back * back + side * side);
      light[x] *= holder_edge_(middle - wall);
    }
  }
}

void Renderer::draw_needle(const NeedlePose& needle) {
  const double pixel_um = scenario_.image.pixel_size_um;
  const Eigen::Vector2d along = -needle.direction, across(-along.y(), along.x());
  const auto& tools = scenario_.tools;
  Strip strip{needle.tip_um / pixel_um, along, across, (tools.needle_shaft_radius_um + kBand_um) / pixel_um,
              -kBand_um / pixel_um};
  const auto tip = static_cast<float>(tools.needle_tip_radius_um);
  const auto slope = static_cast<float>(std::tan(tools.needle_taper_deg * kPi / 180));
  const float cosine = 1 / std::sqrt(1 + slope * slope);
  for (int y = 0, first, last; y < light_.rows; ++y) {
    if (!strip.columns(y, light_.cols, first, last)) continue;
    float* light = light_[y];
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector2d from = pixel_um * (Eigen::Vector2d(x, y) - strip.origin);
      const float back = static_cast<float>(from.dot(along)) - tip,
                  side = std::abs(static_cast<float>(from.dot(across)));
      // The round tip, then the cone and the shaft.
      const float distance = back < 0 ? std::sqrt(back * back + side * side) - tip
                                      : cosine * (side - static_cast<float>(needle_half_width_um(tools, back + tip)));
      light[x] *= needle_edge_(distance);
    }
  }
}

template <class Pixel>
void Renderer::count_light(long frame_index) {
  constexpr float kFull = std::numeric_limits<Pixel>::max();
  const auto& optics = scenario_.optics;
  const float shot = static_cast<float>(1 / optics.full_well_electrons);
  const auto read = static_cast<float>(std::pow(optics.read_noise_electrons / optics.full_well_electrons, 2));
  for (int y = 0; y < light_.rows; ++y) {
    const float* light = light_[y];
    auto* pixel = frame_.ptr<Pixel>(y);
    if (optics.noise) {
      // Shot noise has the square root of the light, read noise is the same everywhere.
      const float* noise = noise_.row(frame_index, y);
      for (int x = 0; x < light_.cols; ++x) {
        const float counted = light[x] + noise[x] * std::sqrt(std::max(0.0f, light[x]) * shot + read);
        pixel[x] = static_cast<Pixel>(std::min(1.0f, std::max(0.0f, counted)) * kFull + 0.5f);
      }
    } else {
      for (int x = 0; x < light_.cols; ++x)
        pixel[x] = static_cast<Pixel>(std::min(1.0f, std::max(0.0f, light[x])) * kFull + 0.5f);
    }
  }
}

}  // namespace pellucida
