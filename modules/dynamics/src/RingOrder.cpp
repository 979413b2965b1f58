#include "RingOrder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pellucida {
namespace {

/// Neighbours of an inner node of a regular triangular lattice.
constexpr int kRegularValence = 6;

std::vector<std::vector<int>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.points_um.cols()));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      neighbours[static_cast<std::size_t>(mesh.triangles(corner, t))].push_back(mesh.triangles((corner + 1) % 3, t));
    }
  }
  return neighbours;
}

}  // namespace

std::vector<int> ring_order(const TriangleMesh& mesh) {
  // On a closed surface each edge leaves both its ends once.
  const auto neighbours = neighbours_of(mesh);
  const std::size_t n = neighbours.size();
  const auto irregularity = [&](std::size_t node) {
    return std::abs(static_cast<int>(neighbours[node].size()) - kRegularValence);
  };
  std::size_t pole = 0;
  for (std::size_t node = 1; node < n; ++node) {
    if (irregularity(node) > irregularity(pole)) pole = node;
  }

  // Rings: steps from the pole.
  std::vector<int> ring(n, -1);
  std::vector<int> queue{static_cast<int>(pole)};
  ring[pole] = 0;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    for (const int other : neighbours[static_cast<std::size_t>(queue[k])]) {
      if (ring[static_cast<std::size_t>(other)] >= 0) continue;
      ring[static_cast<std::size_t>(other)] = ring[static_cast<std::size_t>(queue[k])] + 1;
      queue.push_back(other);
    }
  }

  // Angles about the axis from the centre to the pole.
  const Eigen::Vector3d centre = mesh.points_um.rowwise().mean();
  const Eigen::Vector3d axis = (mesh.points_um.col(static_cast<Eigen::Index>(pole)) - centre).normalized();
  const Eigen::Vector3d across = axis.unitOrthogonal();
  const Eigen::Vector3d third = axis.cross(across);
  std::vector<double> angle(n);
  for (std::size_t node = 0; node < n; ++node) {
    const Eigen::Vector3d p = mesh.points_um.col(static_cast<Eigen::Index>(node)) - centre;
    angle[node] = std::atan2(p.dot(third), p.dot(across));
  }

  std::vector<int> order(n);
  for (std::size_t k = 0; k < n; ++k) order[k] = static_cast<int>(k);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto p = static_cast<std::size_t>(a), q = static_cast<std::size_t>(b);
    if (ring[p] != ring[q]) return ring[p] < ring[q];
    return angle[p] != angle[q] ? angle[p] < angle[q] : a < b;
  });
  std::vector<int> place(n);
  for (std::size_t k = 0; k < n; ++k) place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  return place;
}

}  // namespace pellucida
