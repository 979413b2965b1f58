#include "pellucida/reconstruction/Revolve.h"

#include <cmath>
#include <numbers>

#include "Meridian.h"
#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

int meridian_count(const RevolveOptions& options) {
  return static_cast<int>(std::lround(360.0 / options.step_deg));
}

// Quads between rings, triangles at the poles, corners ordered so that normals point outward.
std::vector<std::array<int, 4>> make_cells(int rings, int sectors) {
  std::vector<std::array<int, 4>> cells;
  cells.reserve(static_cast<std::size_t>((rings + 1) * sectors));
  const auto node = [&](int ring, int sector) { return 1 + ring * sectors + sector % sectors; };
  const int far_pole = 1 + rings * sectors;
  for (int k = 0; k < sectors; ++k) cells.push_back({0, node(0, k), node(0, k + 1), -1});
  for (int j = 0; j + 1 < rings; ++j) {
    for (int k = 0; k < sectors; ++k) cells.push_back({node(j, k), node(j + 1, k), node(j + 1, k + 1), node(j, k + 1)});
  }
  for (int k = 0; k < sectors; ++k) cells.push_back({node(rings - 1, k), far_pole, node(rings - 1, k + 1), -1});
  return cells;
}

}  // namespace

void validate(const RevolveOptions& options) {
  const double sectors = 360.0 / options.step_deg;
  constexpr double kLeastStep_deg = 0.1;
  if (!(options.step_deg >= kLeastStep_deg) || sectors < 3.0 || std::abs(sectors - std::round(sectors)) > 1e-6) {
    throw UsageError("angular step " + std::to_string(options.step_deg) +
                     " degrees: give a divisor of 360 between 0.1 and 120, such as 10, 30 or 60");
  }
  if (options.meridian_point_count < 5) {
    throw UsageError("meridian points " + std::to_string(options.meridian_point_count) + ": give 5 or more");
  }
  if (!(options.pole_density_ratio > 0.0) || options.pole_density_ratio > 1.0) {
    throw UsageError("pole density ratio " + std::to_string(options.pole_density_ratio) + ": give a number in (0, 1]");
  }
}

expected<RevolvedMesh, std::string> revolve(const Contour_um& contour_um, const Eigen::Vector2d& center_um,
                                            const Eigen::Vector2d& axis, const RevolveOptions& options) {
  const auto fractions = graded_fractions(options.meridian_point_count, options.pole_density_ratio);
  const auto halves = cut_meridians(contour_um, center_um, axis, fractions);
  if (!halves) return unexpected<std::string>(halves.error());

  // The cell's own frame in W: t in the image plane, z into the scene, the axis towards the needle.
  const Eigen::Vector3d center(center_um.x(), center_um.y(), 0.0);
  const Eigen::Vector3d along(axis.x(), axis.y(), 0.0);
  const Eigen::Vector3d across(-axis.y(), axis.x(), 0.0);
  const Eigen::Vector3d depth = Eigen::Vector3d::UnitZ();

  const int rings = options.meridian_point_count - 2;
  const int sectors = meridian_count(options);
  RevolvedMesh result;
  result.mesh.nodes_um.resize(3, 2 + rings * sectors);
  result.rest_direction.resize(3, 2 + rings * sectors);

  // One node: the blend of both halves at phi, and the direction it had on the sphere.
  const auto place = [&](Eigen::Index node, Eigen::Index j, double phi_rad) {
    const double positive_share = 0.5 * (1.0 + std::cos(phi_rad));
    const Eigen::Vector2d p =
        positive_share * halves->positive.col(j) + (1.0 - positive_share) * halves->negative.col(j);
    const Eigen::Vector3d outward = std::cos(phi_rad) * across + std::sin(phi_rad) * depth;
    result.mesh.nodes_um.col(node) = center + p.x() * along + p.y() * outward;
    const double polar_rad = std::numbers::pi * fractions[j];
    result.rest_direction.col(node) = std::cos(polar_rad) * along + std::sin(polar_rad) * outward;
  };
  place(0, 0, 0.0);
  for (int j = 0; j < rings; ++j) {
    for (int k = 0; k < sectors; ++k) place(1 + j * sectors + k, j + 1, 2.0 * std::numbers::pi * k / sectors);
  }
  place(1 + rings * sectors, rings + 1, 0.0);
  result.mesh.cells = make_cells(rings, sectors);
  return result;
}

}  // namespace pellucida
