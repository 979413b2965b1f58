#pragma once
#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// A rubber-like membrane at finite strain: constant-strain triangles in plane stress, the thickness following from the
/// stretch. With C the right Cauchy-Green tensor in the triangle's plane and J^2 = det C,
///
///   U = sum over triangles  A h mu/2 [ tr C - 2 + (J^(-2 gamma) - 1) / gamma ],
///   mu = E / (2 (1 + nu)),   gamma = nu / (1 - nu).
///
/// nu = 1/2 (gamma = 1) is the incompressible neo-Hookean solid: the thickness is h / J. Below 1/2 it is the
/// compressible solid of Blatz and Ko (Trans. Soc. Rheol. 6, 1962, eq. for f = 1), whose plane-stress thickness is
/// h J^-gamma. Both have Young's modulus E and Poisson's ratio nu at small strain. The rest shape is free of stress.
class NeoHookeanTerm final : public EnergyTerm {
 public:
  /// Throws UsageError unless modulus and thickness are above 0 and 0 < nu <= 1/2, or when a triangle has no area.
  NeoHookeanTerm(const TriangleMesh& rest, double young_modulus_uN_per_um2, double poisson_ratio, double thickness_um);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

  /// The two principal stretches of each triangle, the larger first (2 x m).
  Eigen::Matrix2Xd principal_stretches(const Eigen::Matrix3Xd& x_um) const;

 private:
  struct Element {
    std::array<int, 3> nodes{};
    // tr C = m11 d1.d1 + 2 m12 d1.d2 + m22 d2.d2 of the deformed edges d1, d2; det C = |d1 x d2|^2 / gram.
    double m11 = 0.0, m12 = 0.0, m22 = 0.0;
    double gram_um4 = 0.0;
    double stiffness_uN_um = 0.0;  // A h mu / 2
  };
  double gamma_ = 1.0;
  std::vector<Element> elements_;
  std::vector<std::array<BlockSlot, 6>> slots_;  // 00 10 11 20 21 22
};

}  // namespace pellucida
