#include "NodalField.h"

#include <cmath>

namespace pellucida {
namespace {

/// How a tool's force is spread over its patch depends on the bond and on the wall beneath it: single nodes differ from
/// those of a solid by about this share of their root mean square (docs/method.md, 4.5).
constexpr double kToolSpread_ratio = 1.0;

/// The tool's force on the membrane's nodes.
Eigen::Matrix3Xd load_of(const AttachmentTerm& tool, const Eigen::Matrix3Xd& x_um) {
  Eigen::Matrix3Xd gradient_uN = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  tool.add(x_um, &gradient_uN, nullptr);
  return -gradient_uN;
}

/// Adds to the variance of the nodes under a tool what its distribution leaves open.
void add_spread(const AttachmentTerm& tool, const Eigen::Matrix3Xd& load_uN, Eigen::VectorXd& variance_uN2) {
  if (tool.nodes().empty()) return;
  const double mean_square_uN2 = load_uN.squaredNorm() / static_cast<double>(tool.nodes().size());
  for (const int node : tool.nodes()) variance_uN2[node] += std::pow(kToolSpread_ratio, 2) * mean_square_uN2;
}

}  // namespace

void fill_nodes(const Indenter& indenter, double scale, bool contact, ForceEstimate& estimate) {
  const MembraneModel& model = indenter.model();
  const Eigen::Matrix3Xd& x = indenter.positions_um();
  const double of_tools = scale * indenter.force_ratio(), of_liquid = scale * indenter.pressure_ratio();
  // In equilibrium a node's elastic force balances the liquid's push, P grad V, and the tools'.
  const double pressure_uN_per_um2 = model.setup().keeps_volume ? model.volume().pressure_uN_per_um2(x) : 0.0;
  const Eigen::Matrix3Xd liquid_uN = pressure_uN_per_um2 * model.volume().gradient_of_volume(x);
  const Eigen::Matrix3Xd force = of_tools * indenter.elastic_force_uN() + (of_tools - of_liquid) * liquid_uN;
  estimate.force_uN = estimate.rotation_WC * force;
  // A cell that was let go lies at rest, and its bonds where they were last.
  const double borne = contact ? of_tools : 0.0;
  const Eigen::Matrix3Xd needle = borne * load_of(model.tip(), x), holder = borne * load_of(model.holder(), x);
  estimate.needle_force_uN = estimate.rotation_WC * needle;
  estimate.holder_force_uN = estimate.rotation_WC * holder;
  const double relative = estimate.errors.relative();
  Eigen::VectorXd variance_uN2 = relative * relative * force.colwise().squaredNorm().transpose();
  if (contact) {
    variance_uN2 += std::pow(of_tools * estimate.depth_sigma_um, 2) *
                    indenter.elastic_slope_uN_per_um().colwise().squaredNorm().transpose();
    add_spread(model.tip(), needle, variance_uN2);
    add_spread(model.holder(), holder, variance_uN2);
  }
  estimate.force_sigma_uN = variance_uN2.array().sqrt().matrix();
  const Eigen::VectorXd areas_um2 = node_areas_um2(x, model.rest().triangles);
  const Eigen::VectorXd rest_um2 = node_areas_um2(model.rest().points_um, model.rest().triangles);
  estimate.tension_uN_per_um = of_liquid * model.springs().tension_uN_per_um(x, areas_um2);
  estimate.area_strain_percent = 100.0 * (areas_um2.array() / rest_um2.array() - 1.0);
}

double damping_uN_s_per_um(const Indenter& indenter, double connector_damping_uN_s_per_um) {
  const Eigen::Matrix3Xd& velocity = indenter.depth_tangent();
  Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, velocity.cols());
  indenter.model().springs().add_damping(indenter.positions_um(), velocity, connector_damping_uN_s_per_um, force);
  return -(force.array() * velocity.array()).sum();
}

}  // namespace pellucida
