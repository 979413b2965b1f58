#include "NodalField.h"

namespace pellucida {

void fill_nodes(const Indenter& indenter, double scale, bool contact, ForceEstimate& estimate) {
  const MembraneModel& model = indenter.model();
  const Eigen::Matrix3Xd& x = indenter.positions_um();
  const Eigen::Matrix3Xd force = scale * model.elastic_force_uN(x);
  estimate.force_uN = estimate.rotation_WC * force;
  const double relative = estimate.errors.relative();
  estimate.force_sigma_uN = relative * force.colwise().norm().transpose();
  if (contact && estimate.depth_sigma_um > 0.0) {
    constexpr double kProbe_um = 1e-3;
    const Eigen::Matrix3Xd moved = scale * model.elastic_force_uN(x + kProbe_um * indenter.depth_tangent());
    const Eigen::VectorXd by_depth =
        ((moved - force) * (estimate.depth_sigma_um / kProbe_um)).colwise().norm().transpose();
    estimate.force_sigma_uN = (estimate.force_sigma_uN.array().square() + by_depth.array().square()).sqrt().matrix();
  }
  estimate.tension_uN_per_um = scale * model.springs().tension_uN_per_um(x, node_areas_um2(x, model.rest().triangles));
}

double damping_uN_s_per_um(const Indenter& indenter, double connector_damping_uN_s_per_um) {
  const Eigen::Matrix3Xd& velocity = indenter.depth_tangent();
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, velocity.cols());
  indenter.model().springs().add_damping(indenter.positions_um(), velocity, connector_damping_uN_s_per_um, force);
  return -(force.array() * velocity.array()).sum();
}

}  // namespace pellucida
