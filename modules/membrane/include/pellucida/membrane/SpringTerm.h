#pragma once
#include <Eigen/Core>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// Constants of the connectors that meet at each node; a connector takes the mean of its two ends.
struct SpringConstants {
  Eigen::VectorXd k2_uN_per_um;  ///< (n) linear part K2 of the second-order law
  Eigen::VectorXd k1_uN_per_um;  ///< (n) quadratic part K1
};

/// The connectors of the mass-spring-damper model, eq. (1) of the paper:
///
///   f_i = sum_j k_ij (L_ij / |p| - 1) p - b (v.p)/(p.p) p,   p = x_i - x_j,   v = v_i - v_j
///   k_ij = (A_ij / L_ij^2) (K2 + K1 e^2),   e = |p| / L_ij - 1
///
/// with X-shaped connectors: each pair of triangles carries a spring along the shared edge and one between the two
/// opposite vertices, each with A_ij = (area1 + area2) / 6, half of the pair's share of the surface. Energy of a
/// connector: U = A_ij (K2 e^2 / 2 + K1 e^4 / 4). A connector softens to nothing at e^2 = -K2 / (3 K1) when K1 < 0.
class SpringTerm final : public EnergyTerm {
 public:
  /// One connector between the nodes i and j.
  struct Spring {
    int i = 0;
    int j = 0;
    double rest_length_um = 0.0;
    double area_um2 = 0.0;  ///< A_ij
    double k2_uN_per_um = 0.0;
    double k1_uN_per_um = 0.0;
    bool is_link = false;  ///< joins the two vertices opposite an edge; otherwise an edge itself

    /// Tension at `length_um`, uN; positive where the connector pulls its nodes together.
    double pull_uN(double length_um) const {
      const double e = length_um / rest_length_um - 1.0;
      return area_um2 / rest_length_um * e * (k2_uN_per_um + k1_uN_per_um * (e * e));
    }
  };

  SpringTerm(const TriangleMesh& rest, const std::vector<TrianglePair>& pairs, const SpringConstants& constants);

  /// Lays `constants` over the same connectors.
  void set_constants(const SpringConstants& constants);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

  /// Adds the dampers' forces -b (v.p)/(p.p) p (uN) on each node. Their power, -b (v.p)^2/(p.p) a connector, is never
  /// positive.
  void add_damping(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& velocity_um_per_s, double damping_uN_s_per_um,
                   Eigen::Matrix3Xd& force_uN) const;

  /// Mean membrane tension at each node (uN/um): half the trace of the stress resultant that the connectors carry,
  /// N = 1/(2 A_i) sum_j T_ij |p| / 2, T_ij the connector's pull and A_i the node's present area. Positive = stretched.
  Eigen::VectorXd tension_uN_per_um(const Eigen::Matrix3Xd& x_um, const Eigen::VectorXd& node_areas_um2) const;

  /// The largest stiffness of a connector along itself at rest, A K2 / L^2.
  double stiffest_uN_per_um() const;

  std::size_t count() const noexcept { return springs_.size(); }
  const std::vector<Spring>& springs() const noexcept { return springs_; }

 private:
  struct Slots {
    BlockSlot ii, jj, ij;
  };
  std::vector<Spring> springs_;
  std::vector<Slots> slots_;
};

}  // namespace pellucida
