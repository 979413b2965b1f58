#pragma once
#include <Eigen/Core>
#include <vector>

namespace pellucida {

/// A closed triangulated surface, oriented outwards (counter-clockwise seen from outside).
struct TriangleMesh {
  Eigen::Matrix3Xd points_um;  ///< (3 x n)
  Eigen::Matrix3Xi triangles;  ///< (3 x m) node indices
};

/// Two triangles that share the edge (a, b). The outward orientation is (a, b, c) and (b, a, d).
struct TrianglePair {
  int a = 0;
  int b = 0;
  int c = 0;  ///< the vertex opposite the edge in the triangle that runs a -> b
  int d = 0;  ///< the vertex opposite the edge in the triangle that runs b -> a
};

/// One pair for each edge, sorted by (a, b) with a < b. Throws Error (internal error) when the surface is not closed,
/// i.e. when some edge does not belong to exactly two triangles that traverse it in opposite directions.
std::vector<TrianglePair> triangle_pairs(const Eigen::Matrix3Xi& triangles);

/// Area of each triangle, um^2 (m).
Eigen::VectorXd triangle_areas_um2(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles);

/// A third of the area of the triangles around each node, um^2 (n).
Eigen::VectorXd node_areas_um2(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles);

/// Enclosed volume, um^3; positive for an outward orientation.
double enclosed_volume_um3(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles);

}  // namespace pellucida
