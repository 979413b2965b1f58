#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// Bending angle of a hinge: positive when the fold bulges outwards. Nodes in the order (a, b, c, d) of a TrianglePair.
double hinge_angle_rad(const std::array<Eigen::Vector3d, 4>& x_um);

/// Bending of the membrane, one hinge an edge: U = 1/2 g D |edge|^2 / (area1 + area2) (theta - theta0)^2, with
/// D = E h^3 / (12 (1 - nu^2)), the edge and areas at rest, theta the angle between the two triangles' normals.
class HingeTerm final : public EnergyTerm {
 public:
  /// `rigidity_uN_um` (n) holds g D by node; a hinge takes the mean of its edge's two ends. The rest shape is
  /// stress-free.
  HingeTerm(const TriangleMesh& rest, const std::vector<TrianglePair>& pairs, const Eigen::VectorXd& rigidity_uN_um);

  void set_rigidity(const Eigen::VectorXd& rigidity_uN_um);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

 private:
  struct Hinge {
    std::array<int, 4> nodes{};
    double rest_angle_rad = 0.0;
    double shape_ratio = 0.0;  // |edge|^2 / (area1 + area2) at rest
    double stiffness_uN_um = 0.0;
  };
  std::vector<Hinge> hinges_;
  std::vector<std::array<BlockSlot, 10>> slots_;
};

}  // namespace pellucida
