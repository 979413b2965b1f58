#include "pellucida/teaching/CellMesh.h"

#include <Eigen/Geometry>

#include "pellucida/teaching/TeachingParameters.h"

namespace pellucida {
namespace {

SpringDirection direction_of(const SpringTerm::Spring& spring, const Eigen::Matrix3Xd& rest_um) {
  if (spring.is_link) return SpringDirection::kDiagonal;
  const Eigen::Vector3d middle = 0.5 * (rest_um.col(spring.i) + rest_um.col(spring.j));
  const Eigen::Vector3d along = rest_um.col(spring.i) - rest_um.col(spring.j);
  // At a pole every direction is a meridian's: the parallel has no length there.
  const Eigen::Vector3d parallel = Eigen::Vector3d::UnitZ().cross(middle);
  if (parallel.norm() < 1e-9 * middle.norm()) return SpringDirection::kMeridian;
  const double share = along.normalized().dot(parallel.normalized());
  return share * share > 0.5 ? SpringDirection::kParallel : SpringDirection::kMeridian;
}

}  // namespace

CellMesh mesh_of(const MembraneModel& model, const CellProfile& profile) {
  CellMesh mesh;
  mesh.triangles = model.rest().triangles;
  for (const auto& spring : model.springs().springs()) {
    mesh.pairs.push_back({spring.i, spring.j});
    mesh.directions.push_back(direction_of(spring, model.rest().points_um));
  }
  mesh.mid_radius_um = model.setup().mid_radius_um;
  mesh.thickness_um = model.setup().thickness_um;
  mesh.tip_radius_um = profile.tip_radius_um;
  mesh.holder_ring_um = profile.holder_ring_um;
  mesh.push = model.setup().push;
  mesh.holder = model.setup().holder;
  mesh.deepest_um = deepest_um(profile);
  return mesh;
}

}  // namespace pellucida
