#pragma once
#include <Eigen/Core>
#include <functional>

#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// A triangulated sphere with the plane y = 0 as its mirror.
struct GradedSphere {
  TriangleMesh mesh;
  /// The nodes 0 .. meridian_count - 1 lie in the plane y = 0, one after the other round the sphere, from +z towards
  /// +x.
  int meridian_count = 0;
};

/// Target length of an edge at a point of the sphere, um. Must be symmetric in y.
using EdgeLength = std::function<double(const Eigen::Vector3d& point_um)>;

/// A sphere of radius `radius_um` about the origin whose triangles are close to equilateral, with edges as long as
/// `edge_length_um` says where they lie. Node 0 lies at `start_angle_rad` = atan2(x, z) of the plane y = 0. Half the
/// sphere is filled by inserting a node into the triangle that is most too large and flipping edges until every
/// circumscribed circle is empty (Delaunay, by Lawson's flips), then evened out by moving each node to the weighted
/// mean of its triangles' middles; the other half is its mirror image. Takes some tens of milliseconds for 1,500 nodes;
/// the same input gives the same mesh. Throws UsageError when radius or a length isn't above 0, or when the mesh would
/// have more than 200,000 nodes.
GradedSphere make_graded_sphere_mesh(double radius_um, double start_angle_rad, const EdgeLength& edge_length_um);

}  // namespace pellucida
