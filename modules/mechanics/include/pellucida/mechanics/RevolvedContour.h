#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/mechanics/ShapeAudit.h"
#include "pellucida/membrane/MembraneModel.h"
#include "pellucida/membrane/NormalObservationTerm.h"

namespace pellucida {

/// The contour revolved about the contact point's axis, as seen from the model's nodes: each node's distance to it
/// along the node's own normal. A node between the section's two sides takes their mean, weighted by the azimuth.
/// `residual_um` and `normal` (3 x n) are written; nodes that see nothing get 0.
void revolve_residual(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um, const ShapeAuditor& section,
                      Eigen::VectorXd& residual_um, Eigen::Matrix3Xd& normal);

/// Weak observations of every node: its place on the revolved contour, along its normal. `weight_uN_per_um3`: omega.
std::vector<NormalObservationTerm::Observed> observe_revolved(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um,
                                                              const ShapeAuditor& section, double weight_uN_per_um3);

/// Every node laid on the revolved contour, at its nearest place along its normal.
Eigen::Matrix3Xd lay_on_contour(const TriangleMesh& rest, const Eigen::Matrix3Xd& x_um, const ShapeAuditor& section);

/// The force of the needle along the push, uN, according to a model whose nodes are all prescribed (`laid_um`, 3 x n,
/// frame C): the sum of the connectors' forces under the tip. Biased even with a perfect shape, since each little
/// mismatch counts with the membrane's full stiffness, and drowned by noise: for teaching only.
double naive_force_uN(const MembraneModel& model, const Eigen::Matrix3Xd& laid_um);

}  // namespace pellucida
