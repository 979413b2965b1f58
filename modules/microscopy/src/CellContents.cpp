#include "CellContents.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pellucida/microscopy/SeededNumbers.h"

namespace pellucida {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
// The objective's depth of field spreads what lies above or below, um for a um.
constexpr double kSpread_ratio = 0.06;
constexpr double kLipid_index = 0.08, kLipid_absorption_per_um = 0.035;  // droplets of pig and cow

// A place in the ball of radius 1: share of the radius in the image plane, angle, depth.
struct Place {
  double ratio, angle, depth;
};
Place in_ball(std::mt19937_64& engine) {
  const double radius = std::cbrt(uniform(engine)), up = 2 * uniform(engine) - 1, angle = kFullTurn * uniform(engine);
  return {radius * std::sqrt(1 - up * up), angle, radius * up};
}

}  // namespace

CellContents::CellContents(const Look::Cell& look, double cell_radius_um, double pixel_size_um, std::uint64_t seed)
    : look_(look), pixel_size_um_(pixel_size_um) {
  std::mt19937_64 engine(mix(seed ^ 0x636f6e74656e74ULL));
  const double finest_um = 0.6 * pixel_size_um, volume_ratio = std::pow(cell_radius_um / 50, 2);
  auto grains = [&](int count, double sigma_um, double phase_rad) {
    for (int k = 0; k < count; ++k) {
      const Place place = in_ball(engine);
      const double size = sigma_um * (0.7 + 0.6 * uniform(engine));
      const double spread = std::hypot(std::max(size, finest_um), kSpread_ratio * cell_radius_um * place.depth);
      const double phase = look.grain_ratio * phase_rad * normal(engine) * std::pow(size / spread, 2);
      grains_.push_back({static_cast<float>(0.97 * place.ratio), static_cast<float>(place.angle),
                         static_cast<float>(spread), static_cast<float>(phase)});
    }
  };
  if (look.grain_ratio > 0) {
    grains(static_cast<int>(2600 * volume_ratio), 0.7, 0.55);
    grains(static_cast<int>(260 * volume_ratio), 1.9, 0.5);
    grains(static_cast<int>(40 * volume_ratio), 6.0, 0.8);
  }
  const auto droplet_count = static_cast<int>(900 * look.lipid_ratio * volume_ratio);
  for (int k = 0; k < droplet_count; ++k) {
    const Place place = in_ball(engine);
    const double radius = 0.5 + 1.6 * std::pow(uniform(engine), 2);
    droplets_.push_back({static_cast<float>(0.93 * place.ratio), static_cast<float>(place.angle),
                         static_cast<float>(radius),
                         static_cast<float>(kSpread_ratio * cell_radius_um * std::abs(place.depth))});
  }
  for (int k = 0; k < look.cumulus_count; ++k) {
    const double up = 2 * uniform(engine) - 1, angle = kFullTurn * uniform(engine);
    const double radius = look.cumulus_radius_um * (0.7 + 0.6 * uniform(engine));
    // Most lie beside the cell: the washed ones that are left hold on at the rim.
    const double ratio = std::sqrt(1 - 0.5 * up * up);
    cumulus_.push_back({angle, ratio * (1 + 0.7 * radius / cell_radius_um), radius, 0.02 + 0.015 * uniform(engine),
                        0.05 * cell_radius_um * std::abs(up)});
  }
  nucleus_ = {static_cast<float>(0.5 * uniform(engine)), static_cast<float>(kFullTurn * uniform(engine))};
}

Eigen::Vector2d CellContents::contour_place(const MicroscopeCell& cell, const Contour_um& contour,
                                            double angle_rad) const {
  const auto& angles = cell.angle_rad;
  const double wanted = angles(0) + std::fmod(std::fmod(angle_rad - angles(0), kFullTurn) + kFullTurn, kFullTurn);
  const auto* first = angles.data();
  const Eigen::Index k =
      std::min<Eigen::Index>(std::lower_bound(first, first + angles.size(), wanted) - first, angles.size() - 1);
  return contour.col(k);
}

void CellContents::add_grain(cv::Mat1f& phase_rad, const Eigen::Vector2d& place_px, float sigma_px, float phase) const {
  // A Gaussian is a product of one across and one down.
  constexpr int kMost = 128;
  const int reach = std::min(kMost / 2 - 1, static_cast<int>(std::ceil(3 * sigma_px)));
  const int x0 = static_cast<int>(std::floor(place_px.x())) - reach,
            y0 = static_cast<int>(std::floor(place_px.y())) - reach, count = 2 * reach + 2;
  float across[kMost], down[kMost];
  const float scale = -0.5f / (sigma_px * sigma_px);
  for (int k = 0; k < count; ++k) {
    const auto dx = static_cast<float>(x0 + k - place_px.x()), dy = static_cast<float>(y0 + k - place_px.y());
    across[k] = std::exp(scale * dx * dx);
    down[k] = phase * std::exp(scale * dy * dy);
  }
  const int first = std::max(0, -x0), last = std::min(count, phase_rad.cols - x0);
  for (int j = std::max(0, -y0); j < std::min(count, phase_rad.rows - y0); ++j) {
    float* row = phase_rad[y0 + j] + x0;
    for (int i = first; i < last; ++i) row[i] += across[i] * down[j];
  }
}

void CellContents::add(OpticalPath& path, const MicroscopeCell& cell) {
  flow_.update(cell.ooplasm_um, cell.angle_rad);
  auto place_um = [&](float ratio, float angle) {
    const Eigen::Vector2d from = flow_.place_of(ratio, angle).cast<double>();
    return cell.to_image(flow_.center() + from);
  };
  const auto pixel = static_cast<float>(pixel_size_um_);
  for (const Grain& grain : grains_)
    add_grain(path.phase_rad, place_um(grain.ratio, grain.angle) / pixel_size_um_, grain.sigma_um / pixel,
              grain.phase_rad);
  for (const Droplet& droplet : droplets_)
    add_ball(path,
             {place_um(droplet.ratio, droplet.angle), static_cast<double>(droplet.radius_um), kLipid_index,
              kLipid_absorption_per_um},
             pixel_size_um_, static_cast<double>(droplet.blur_um));
  if (look_.nucleus_radius_um > 0) {
    // Clearer than the ooplasm, with a dense nucleolus.
    const Eigen::Vector2d middle = place_um(nucleus_.x(), nucleus_.y());
    add_ball(path, {middle, look_.nucleus_radius_um, -0.008, 0.0}, pixel_size_um_, 0.6);
    add_ball(
        path,
        {middle + Eigen::Vector2d(0.25, -0.2) * look_.nucleus_radius_um, 0.28 * look_.nucleus_radius_um, 0.03, 0.004},
        pixel_size_um_, 0.5);
  }
  if (look_.polar_body_radius_um > 0) {
    const double angle = look_.polar_body_angle_deg * std::numbers::pi / 180, radius = look_.polar_body_radius_um;
    const Eigen::Vector2d at = contour_place(cell, cell.inner_um, angle);
    const Eigen::Vector2d inwards = (flow_.center() - at).normalized();
    add_ball(path, {cell.to_image(at + 0.95 * radius * inwards), radius, 0.03, 0.002}, pixel_size_um_);
  }
  for (const Cumulus& body : cumulus_) {
    const Eigen::Vector2d at = contour_place(cell, cell.outer_um, body.angle_rad);
    const Eigen::Vector2d place = flow_.center() + body.ratio * (at - flow_.center());
    add_ball(path, {cell.to_image(place), body.radius_um, body.index, 0.003}, pixel_size_um_, body.blur_um);
    add_ball(path, {cell.to_image(place + Eigen::Vector2d(0.2, 0.1) * body.radius_um), 0.5 * body.radius_um, 0.012, 0},
             pixel_size_um_, body.blur_um);
  }
}

}  // namespace pellucida
