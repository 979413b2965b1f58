#include "pellucida/reconstruction/ClosedMesh.h"

#include <Eigen/Geometry>
#include <map>
#include <utility>

namespace pellucida {
namespace {

// Calls `visit(a, b, c, weight)` for the triangles of a cell: one with weight 1, or the four of a quad with weight 1/2.
template <class Visit>
void for_each_triangle(const ClosedMesh& mesh, Visit visit) {
  for (const auto& cell : mesh.cells) {
    const auto node = [&](int i) -> Eigen::Vector3d { return mesh.nodes_um.col(cell[static_cast<std::size_t>(i)]); };
    if (ClosedMesh::is_triangle(cell)) {
      visit(node(0), node(1), node(2), 1.0);
      continue;
    }
    visit(node(0), node(1), node(2), 0.5);
    visit(node(0), node(2), node(3), 0.5);
    visit(node(0), node(1), node(3), 0.5);
    visit(node(1), node(2), node(3), 0.5);
  }
}

}  // namespace

double volume_um3(const ClosedMesh& mesh) noexcept {
  if (mesh.nodes_um.cols() == 0) return 0.0;
  // Measured from a point of the mesh, so that a cell far from the origin loses no digits.
  const Eigen::Vector3d origin = mesh.nodes_um.col(0);
  double six_volumes = 0.0;
  for_each_triangle(mesh, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double w) {
    six_volumes += w * (a - origin).dot((b - origin).cross(c - origin));
  });
  return six_volumes / 6.0;
}

double area_um2(const ClosedMesh& mesh) noexcept {
  double twice_area = 0.0;
  for_each_triangle(mesh, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, double w) {
    twice_area += w * (b - a).cross(c - a).norm();
  });
  return 0.5 * twice_area;
}

bool is_closed_and_oriented(const ClosedMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& cell : mesh.cells) {
    const int corners = ClosedMesh::is_triangle(cell) ? 3 : 4;
    for (int i = 0; i < corners; ++i) {
      ++uses[{cell[static_cast<std::size_t>(i)], cell[static_cast<std::size_t>((i + 1) % corners)]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end()) return false;
  }
  return !uses.empty();
}

}  // namespace pellucida
