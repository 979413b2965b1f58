#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "pellucida/membrane/MembraneModel.h"

namespace pellucida {

/// Where a connector runs. An edge counts to the direction it is nearer to, where it lies at rest; meridians run from
/// the needle's contact point to the pole opposite.
enum class SpringDirection : std::uint8_t { kMeridian, kParallel, kDiagonal };

/// What stays of a stepped cell while its nodes move: for views, shared between threads.
struct CellMesh {
  Eigen::Matrix3Xi triangles;             ///< (3 x m)
  std::vector<std::array<int, 2>> pairs;  ///< the connectors' nodes
  std::vector<SpringDirection> directions;
  double mid_radius_um = 0.0;
  double thickness_um = 0.0;
  double tip_radius_um = 0.0;
  double holder_ring_um = 0.0;
  Eigen::Vector3d push = -Eigen::Vector3d::UnitZ();
  Eigen::Vector3d holder = -Eigen::Vector3d::UnitZ();
  double deepest_um = 0.0;
};

CellMesh mesh_of(const MembraneModel& model, const CellProfile& profile);

}  // namespace pellucida
