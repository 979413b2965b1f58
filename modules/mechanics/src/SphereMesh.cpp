#include "pellucida/mechanics/SphereMesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// An icosahedron with vertices on +z and -z; vertex 1 lies at azimuth 0.
std::array<Eigen::Vector3d, 12> icosahedron_vertices() {
  std::array<Eigen::Vector3d, 12> vertices;
  const double z = 1.0 / std::sqrt(5.0);
  const double rho = 2.0 / std::sqrt(5.0);
  vertices[0] = Eigen::Vector3d::UnitZ();
  for (int k = 0; k < 5; ++k) {
    const double upper = 2.0 * std::numbers::pi * k / 5.0;
    const double lower = upper + std::numbers::pi / 5.0;
    vertices[1 + k] = {rho * std::cos(upper), rho * std::sin(upper), z};
    vertices[6 + k] = {rho * std::cos(lower), rho * std::sin(lower), -z};
  }
  vertices[11] = -Eigen::Vector3d::UnitZ();
  return vertices;
}

std::vector<std::array<int, 3>> icosahedron_faces() {
  std::vector<std::array<int, 3>> faces;
  for (int k = 0; k < 5; ++k) {
    const int next = (k + 1) % 5;
    faces.push_back({0, 1 + k, 1 + next});
    faces.push_back({1 + k, 6 + k, 1 + next});
    faces.push_back({1 + next, 6 + k, 6 + next});
    faces.push_back({11, 6 + next, 6 + k});
  }
  return faces;
}

/// Moves a point of the unit sphere towards +z: tan(theta'/2) = tan(theta/2) / grading. Conformal.
Eigen::Vector3d graded(const Eigen::Vector3d& p, double grading) {
  const double rho = std::hypot(p.x(), p.y());
  if (rho < 1e-12) return p;
  const double theta = 2.0 * std::atan(std::tan(0.5 * std::atan2(rho, p.z())) / grading);
  const double scale = std::sin(theta) / rho;
  return {p.x() * scale, p.y() * scale, std::cos(theta)};
}

}  // namespace

TriangleMesh make_sphere_mesh(double radius_um, const SphereMeshOptions& options) {
  const int f = options.frequency;
  if (!(radius_um > 0.0)) throw UsageError("sphere mesh: the radius must be above 0 um");
  if (f < 1 || f > 40)
    throw UsageError("sphere mesh: the frequency is " + std::to_string(f) + "; give one from 1 to 40");
  if (!(options.grading > 0.0)) throw UsageError("sphere mesh: the grading must be above 0");

  // Nodes on shared edges are one node: a node is known by the icosahedron's corners it lies between and its parts of
  // each.
  const auto vertices = icosahedron_vertices();
  std::map<std::array<int, 6>, int> known;
  std::vector<Eigen::Vector3d> points;
  const auto node = [&](const std::array<int, 3>& face, const std::array<int, 3>& parts) {
    std::array<std::pair<int, int>, 3> key{};
    for (int k = 0; k < 3; ++k) key[k] = parts[k] > 0 ? std::pair(face[k], parts[k]) : std::pair(-1, 0);
    std::sort(key.begin(), key.end());
    const std::array<int, 6> flat{key[0].first,  key[0].second, key[1].first,
                                  key[1].second, key[2].first,  key[2].second};
    const auto [entry, is_new] = known.emplace(flat, static_cast<int>(points.size()));
    if (is_new) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) p += parts[k] * vertices[face[k]];
      points.push_back(radius_um * graded(p.normalized(), options.grading));
    }
    return entry->second;
  };

  // Every face in f^2 triangles of its own orientation.
  std::vector<Eigen::Vector3i> triangles;
  for (const auto& face : icosahedron_faces()) {
    for (int i = 0; i < f; ++i) {
      for (int j = 0; j < f - i; ++j) {
        const int k = f - i - j;
        const int corner = node(face, {k, i, j});
        const int along = node(face, {k - 1, i + 1, j});
        const int across = node(face, {k - 1, i, j + 1});
        triangles.emplace_back(corner, along, across);
        if (k >= 2) triangles.emplace_back(along, node(face, {k - 2, i + 1, j + 1}), across);
      }
    }
  }

  TriangleMesh mesh;
  mesh.points_um.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t n = 0; n < points.size(); ++n) mesh.points_um.col(static_cast<Eigen::Index>(n)) = points[n];
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return mesh;
}

}  // namespace pellucida
