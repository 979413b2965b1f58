#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

namespace pellucida {

/// A polygon mesh of quads and triangles, outward oriented (corners anticlockwise seen from outside).
struct ClosedMesh {
  Eigen::Matrix3Xd nodes_um;              ///< (3 x n), frame W
  std::vector<std::array<int, 4>> cells;  ///< node indices; a triangle has -1 in the fourth place

  static bool is_triangle(const std::array<int, 4>& cell) noexcept { return cell[3] < 0; }
};

/// Enclosed volume by the divergence theorem, um^3; positive when the mesh is oriented outward. A quad counts as the
/// mean of its two triangulations, so the figure does not depend on a choice of diagonal.
double volume_um3(const ClosedMesh& mesh) noexcept;

/// Surface area, um^2; a quad counts as the mean of its two triangulations.
double area_um2(const ClosedMesh& mesh) noexcept;

/// True when every edge is used exactly twice, once in each direction: closed, manifold, consistently oriented.
bool is_closed_and_oriented(const ClosedMesh& mesh);

}  // namespace pellucida
