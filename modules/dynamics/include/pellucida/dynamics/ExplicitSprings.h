#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "pellucida/dynamics/Integrator.h"
#include "pellucida/membrane/SpringTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// Eq. (4) on the connectors of eq. (1), springs and dampers both, vectorised: between one and a half and two
/// nanoseconds per spring and step.
///
///   v += (sum_j f_ij + external) dt / m,   x += v dt
///
/// Structure of arrays in single precision; displacements from rest are summed with compensation, so that small steps
/// are not lost. The nodes are renumbered in rings, so that connectors of like direction run along with the nodes:
/// eight connectors whose nodes are consecutive on both sides are one group, read and written without a gather or a
/// branch. Groups follow one another by stretches of nodes that fit the first cache, and by direction in each, so that
/// no group waits for what the one before has just written. A group lacks some of its eight where the mesh is irregular
/// (see `lane_use_ratio`). Any closed triangulation is accepted. Compiled for SSE2 and AVX2, selected when the program
/// starts; both give the same bits. A step allocates nothing.
class ExplicitSprings {
 public:
  /// The connectors of `springs`, on `rest` (3 x n). `node_mass_kg` > 0, `damping_uN_s_per_um` >= 0.
  ExplicitSprings(const TriangleMesh& rest, const SpringTerm& springs, double node_mass_kg, double damping_uN_s_per_um);

  /// Other forces on each node, uN (3 x n): hinges, pressure, tools. Kept until set again; zero at first.
  void set_external_force(const Eigen::Matrix3Xd& force_uN);

  /// Overwrites positions and velocities.
  void set_state(const MotionState& state);
  MotionState state() const;

  /// `count` steps of `dt_s`. The caller ensures stability: dt below 2 sqrt(m / k_max).
  void step(double dt_s, int count = 1);

  /// The connectors' forces at the present state, uN (3 x n).
  Eigen::Matrix3Xd spring_force_uN();

  std::size_t spring_count() const noexcept { return spring_count_; }
  /// Connectors over places for connectors: 1 when every group is full.
  double lane_use_ratio() const noexcept;

 private:
  static constexpr std::size_t kLanes = 8;
  static constexpr int kStretch = 256;  ///< nodes

  /// One group's constants, lane by lane; a missing connector has no stiffness, and no 1 / L^2, which leaves it no
  /// damper.
  struct Group {
    float rest_x[kLanes], rest_y[kLanes], rest_z[kLanes];  // p at rest, um
    float per_square[kLanes];                              // 1 / L^2
    float k2[kLanes], k1[kLanes];                          // A K2 / L^2, A K1 / L^2
  };
  struct Nodes {
    std::vector<float> x, y, z;
    void resize(std::size_t count);
  };
  /// First nodes of a group's two sides.
  struct Sides {
    int i = 0;
    int j = 0;
  };
  friend struct ExplicitSpringsKernel;

  Eigen::Matrix3Xd rest_um_;
  std::vector<int> place_;  ///< of each node, in the numbering by rings
  std::vector<Group> groups_;
  std::vector<Sides> sides_;
  std::size_t spring_count_ = 0;
  float per_mass_ = 0.0f;
  float damping_uN_s_per_um_ = 0.0f;
  Nodes displacement_, lost_, velocity_, external_;
  Nodes force_i_, force_j_;  ///< on the groups' first sides; on their second sides, to be subtracted
};

}  // namespace pellucida
