#pragma once
#include <Eigen/Core>
#include <array>
#include <string_view>

#include "pellucida/dynamics/Integrator.h"
#include "pellucida/membrane/MembraneModel.h"
#include "pellucida/teaching/CellMesh.h"

namespace pellucida {

/// The parts of eq. (1) and (2) on one node.
enum class ForceTerm {
  kMeridianSprings,
  kParallelSprings,
  kDiagonalSprings,
  kHinges,
  kPressure,
  kNeedle,
  kHolder,
  kDampers,
  kInertia,  ///< -m a
};
inline constexpr std::size_t kForceTermCount = 9;
/// "Meridian springs", "Hinges" ...
std::string_view to_string(ForceTerm term) noexcept;

/// Each term's force on a node.
struct NodeForces {
  int node = 0;
  std::array<Eigen::Vector3d, kForceTermCount> force_uN{};

  const Eigen::Vector3d& of(ForceTerm term) const { return force_uN[static_cast<std::size_t>(term)]; }
  /// Their sum: 0 if time were continuous; what is left is the error of the time step.
  Eigen::Vector3d residual_uN() const;
};

/// The forces on `node` at a state whose nodes have the acceleration `acceleration_um_per_s2` (3 x n). Evaluates every
/// term of the model once. Precondition: `directions` are those of the model's springs, `node` one of its nodes.
NodeForces node_forces(const MembraneModel& model, const std::vector<SpringDirection>& directions, double node_mass_kg,
                       double damping_uN_s_per_um, const MotionState& state,
                       const Eigen::Matrix3Xd& acceleration_um_per_s2, int node);

/// Tension of each connector at a shape, uN: above 0 where it pulls.
Eigen::VectorXd spring_pulls_uN(const SpringTerm& springs, const Eigen::Matrix3Xd& x_um);

}  // namespace pellucida
