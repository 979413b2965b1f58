#include "pellucida/membrane/SphereMesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// An icosahedron with the middle of an edge on +z and on -z: the three coordinate planes are its mirrors.
std::array<Eigen::Vector3d, 12> icosahedron_vertices() {
  std::array<Eigen::Vector3d, 12> vertices;
  std::size_t n = 0;
  for (const double one : {1.0, -1.0}) {
    for (const double phi : {std::numbers::phi, -std::numbers::phi}) {
      vertices[n++] = Eigen::Vector3d(0.0, one, phi).normalized();
      vertices[n++] = Eigen::Vector3d(one, phi, 0.0).normalized();
      vertices[n++] = Eigen::Vector3d(phi, 0.0, one).normalized();
    }
  }
  return vertices;
}

/// Its faces, outward: every three vertices that are neighbours of each other.
std::vector<std::array<int, 3>> icosahedron_faces(const std::array<Eigen::Vector3d, 12>& v) {
  const auto neighbours = [&](int i, int j) { return v[i].dot(v[j]) > 0.4; };
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 12; ++i) {
    for (int j = i + 1; j < 12; ++j) {
      for (int k = j + 1; k < 12; ++k) {
        if (!neighbours(i, j) || !neighbours(j, k) || !neighbours(i, k)) continue;
        const bool outward = (v[j] - v[i]).cross(v[k] - v[i]).dot(v[i]) > 0.0;
        faces.push_back({i, outward ? j : k, outward ? k : j});
      }
    }
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
  if (f < 1 || f > 100)
    throw UsageError("sphere mesh: the frequency is " + std::to_string(f) + "; give one from 1 to 100");
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
  for (const auto& face : icosahedron_faces(vertices)) {
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
