#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// A tool bonded elastically to a patch of the membrane: U = 1/2 sum_i w_i |x_i - X_i - u|^2, X_i the node at rest, u
/// the tool's displacement. Read-out of the tool's force on the membrane: F = sum_i w_i (X_i + u - x_i), exact at
/// equilibrium.
class AttachmentTerm final : public EnergyTerm {
 public:
  /// `weights_uN_per_um` (n): integral of the bond's density times each node's shape function.
  AttachmentTerm(const Eigen::Matrix3Xd& rest_um, const Eigen::VectorXd& weights_uN_per_um);

  void set_displacement(const Eigen::Vector3d& displacement_um) { displacement_um_ = displacement_um; }
  const Eigen::Vector3d& displacement_um() const noexcept { return displacement_um_; }

  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

  /// Force of the tool on the membrane, uN.
  Eigen::Vector3d force_uN(const Eigen::Matrix3Xd& x_um) const;
  /// Moment of those forces about the origin, uN um.
  Eigen::Vector3d moment_uN_um(const Eigen::Matrix3Xd& x_um) const;
  /// Weighted mean displacement of the bonded nodes, um.
  Eigen::Vector3d mean_displacement_um(const Eigen::Matrix3Xd& x_um) const;

  /// Nodes that carry weight, and their weights (uN/um).
  const std::vector<int>& nodes() const noexcept { return nodes_; }
  const std::vector<double>& weights_uN_per_um() const noexcept { return weights_; }

 private:
  std::vector<int> nodes_;
  std::vector<double> weights_;
  Eigen::Matrix3Xd rest_um_;  // of those nodes
  Eigen::Vector3d displacement_um_ = Eigen::Vector3d::Zero();
  std::vector<BlockSlot> slots_;
};

/// Weights of the needle's tip: density kt (1 - (r/a)^2) within r < a, r the distance from the contact point, on a
/// sphere about the origin. `contact` is the unit direction of the contact point. The weights sum to kt pi a^2 / 2.
Eigen::VectorXd tip_weights_uN_per_um(const TriangleMesh& sphere, const Eigen::Vector3d& contact, double tip_radius_um,
                                      double density_uN_per_um3);

/// Weights of the holder's mouth: density kr (1 - ((rho - ring)/width)^2) on an annulus, rho the distance from the
/// holder's axis, on the side of `direction` (unit). The weights sum to the density's integral over the sphere.
Eigen::VectorXd holder_weights_uN_per_um(const TriangleMesh& sphere, const Eigen::Vector3d& direction, double ring_um,
                                         double half_width_um, double density_uN_per_um3);

}  // namespace pellucida
