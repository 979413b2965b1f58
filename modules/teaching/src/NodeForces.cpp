#include "pellucida/teaching/NodeForces.h"

#include <Eigen/Geometry>
#include <numeric>

namespace pellucida {
namespace {

constexpr std::array<std::string_view, kForceTermCount> kForceTermNames = {
    "Meridian springs", "Parallel springs", "Diagonals (X)",     "Hinges", "Pressure", "Needle",
    "Holder",           "Dampers",          "Inertia, \u2212m a"};

Eigen::Vector3d force_of(const EnergyTerm& term, const Eigen::Matrix3Xd& x_um, int node) {
  Eigen::Matrix3Xd gradient_uN = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  term.add(x_um, &gradient_uN, nullptr);
  return -gradient_uN.col(node);
}

ForceTerm term_of(SpringDirection direction) {
  switch (direction) {
    case SpringDirection::kMeridian:
      return ForceTerm::kMeridianSprings;
    case SpringDirection::kParallel:
      return ForceTerm::kParallelSprings;
    case SpringDirection::kDiagonal:
      return ForceTerm::kDiagonalSprings;
  }
  return ForceTerm::kDiagonalSprings;
}

}  // namespace

std::string_view to_string(ForceTerm term) noexcept {
  return kForceTermNames[static_cast<std::size_t>(term)];
}

Eigen::Vector3d NodeForces::residual_uN() const {
  return std::accumulate(force_uN.begin(), force_uN.end(), Eigen::Vector3d(Eigen::Vector3d::Zero()));
}

NodeForces node_forces(const MembraneModel& model, const std::vector<SpringDirection>& directions, double node_mass_kg,
                       double damping_uN_s_per_um, const MotionState& state,
                       const Eigen::Matrix3Xd& acceleration_um_per_s2, int node) {
  NodeForces forces;
  forces.node = node;
  forces.force_uN.fill(Eigen::Vector3d::Zero());
  const auto at = [&](ForceTerm term) -> Eigen::Vector3d& { return forces.force_uN[static_cast<std::size_t>(term)]; };

  // The connectors one by one, each to its direction's sum.
  const auto& springs = model.springs().springs();
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const SpringTerm::Spring& spring = springs[k];
    if (spring.i != node && spring.j != node) continue;
    const Eigen::Vector3d away = state.x_um.col(spring.i == node ? spring.j : spring.i) - state.x_um.col(node);
    at(term_of(directions[k])) += spring.pull_uN(away.norm()) * away.normalized();
  }
  at(ForceTerm::kHinges) = force_of(model.hinges(), state.x_um, node);
  if (model.setup().keeps_volume) at(ForceTerm::kPressure) = force_of(model.volume(), state.x_um, node);
  at(ForceTerm::kNeedle) = force_of(model.tip(), state.x_um, node);
  at(ForceTerm::kHolder) = force_of(model.holder(), state.x_um, node);
  Eigen::Matrix3Xd damping_uN = Eigen::Matrix3Xd::Zero(3, state.x_um.cols());
  model.springs().add_damping(state.x_um, state.v_um_per_s, damping_uN_s_per_um, damping_uN);
  at(ForceTerm::kDampers) = damping_uN.col(node);
  at(ForceTerm::kInertia) = -node_mass_kg * acceleration_um_per_s2.col(node);
  return forces;
}

Eigen::VectorXd spring_pulls_uN(const SpringTerm& springs, const Eigen::Matrix3Xd& x_um) {
  const auto& all = springs.springs();
  Eigen::VectorXd pulls_uN(static_cast<Eigen::Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    pulls_uN[static_cast<Eigen::Index>(k)] = all[k].pull_uN((x_um.col(all[k].i) - x_um.col(all[k].j)).norm());
  }
  return pulls_uN;
}

}  // namespace pellucida
