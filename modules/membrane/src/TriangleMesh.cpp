#include "pellucida/membrane/TriangleMesh.h"

#include <Eigen/Geometry>
#include <map>
#include <utility>

#include "pellucida/core/Error.h"

namespace pellucida {

std::vector<TrianglePair> triangle_pairs(const Eigen::Matrix3Xi& triangles) {
  // The vertex opposite each directed edge.
  std::map<std::pair<int, int>, int> opposite;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::pair edge(triangles(corner, t), triangles((corner + 1) % 3, t));
      if (!opposite.emplace(edge, triangles((corner + 2) % 3, t)).second) {
        throw Error(ExitCode::kOurFault,
                    "surface: two triangles run along one edge the same way; orient it consistently");
      }
    }
  }

  // Each edge must be run along once in both ways.
  std::vector<TrianglePair> pairs;
  for (const auto& [edge, c] : opposite) {
    const auto back = opposite.find({edge.second, edge.first});
    if (back == opposite.end())
      throw Error(ExitCode::kOurFault, "surface: an edge has one triangle only; close the surface");
    if (edge.first < edge.second) pairs.push_back({edge.first, edge.second, c, back->second});
  }
  return pairs;
}

Eigen::VectorXd triangle_areas_um2(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles) {
  Eigen::VectorXd areas(triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3d a = points_um.col(triangles(0, t));
    const Eigen::Vector3d b = points_um.col(triangles(1, t));
    const Eigen::Vector3d c = points_um.col(triangles(2, t));
    areas[t] = 0.5 * (b - a).cross(c - a).norm();
  }
  return areas;
}

Eigen::VectorXd node_areas_um2(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles) {
  const Eigen::VectorXd areas = triangle_areas_um2(points_um, triangles);
  Eigen::VectorXd node_areas = Eigen::VectorXd::Zero(points_um.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int corner = 0; corner < 3; ++corner) node_areas[triangles(corner, t)] += areas[t] / 3.0;
  }
  return node_areas;
}

double enclosed_volume_um3(const Eigen::Matrix3Xd& points_um, const Eigen::Matrix3Xi& triangles) {
  double volume = 0.0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3d a = points_um.col(triangles(0, t));
    const Eigen::Vector3d b = points_um.col(triangles(1, t));
    const Eigen::Vector3d c = points_um.col(triangles(2, t));
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

}  // namespace pellucida
