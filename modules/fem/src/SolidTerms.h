#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "AxisymmetricMesh.h"
#include "pellucida/membrane/EnergyTerm.h"

namespace pellucida {

/// A rubber-like solid of revolution at finite strain, nodes at (r, 0, z):
///
///   U = int mu/2 (g(F:F - 3) - 2 ln J) + lambda/2 pi(J - 1)^2 dV,   g(x) = (exp(b x) - 1) / b,
///
/// F the deformation gradient with the hoop stretch r/R, J = det F, b how the material stiffens with strain (0: g = x,
/// neo-Hookean; Demiray, J. Biomech. 5, 1972), pi the projection onto what is linear in each element: nine-node
/// elements with a linear discontinuous pressure, which do not lock (Brezzi and Fortin, Mixed and Hybrid Finite Element
/// Methods, 1991, VI.3), the pressure taken out element by element.
class SolidTerm final : public EnergyTerm {
 public:
  SolidTerm(const AxisymmetricMesh& mesh, double shear_modulus_uN_per_um2, double lame_uN_per_um2,
            double stiffening = 0.0);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

  /// Largest |J - 1| of any element's mean.
  double largest_volume_change(const Eigen::Matrix3Xd& x_um) const;

 private:
  using Strain = Eigen::Matrix<double, 5, 18>;  // (dr/dR, dr/dZ, dz/dR, dz/dZ, r/R) by (r, z) of nine nodes
  struct Point {
    Strain b;
    double volume = 0.0;    // 2 pi R dA
    Eigen::Vector3d modes;  // of the pressure: 1, xi, eta
  };
  struct Element {
    std::array<int, 9> nodes{};
    std::array<Point, 9> points;
    Eigen::Matrix3d inverse_mass;  // of the modes
  };
  double mu_, lambda_, stiffening_;
  std::vector<Element> elements_;
  std::vector<std::array<BlockSlot, 45>> slots_;
};

/// The volume below a surface of revolution, V = -pi int r^2 dz along its meridian, with its derivatives.
class RevolvedSurface {
 public:
  /// `nodes`: from the pole at +z on, three to a quadratic piece.
  explicit RevolvedSurface(std::vector<int> nodes) : nodes_(std::move(nodes)) {}

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const;
  void bind(const BlockMatrix& matrix);
  double volume_um3(const Eigen::Matrix3Xd& x_um) const;
  /// Adds `factor` times dV/dx.
  void add_slope(const Eigen::Matrix3Xd& x_um, double factor, Eigen::Matrix3Xd& sum) const;
  /// Adds `factor` times d2V/dx2.
  void add_curvature(const Eigen::Matrix3Xd& x_um, double factor, BlockMatrix& hessian) const;

 private:
  std::vector<int> nodes_;
  std::vector<std::array<BlockSlot, 6>> slots_;
};

/// The liquid inside a surface of revolution, as VolumeTerm: U = 1/2 kv (V - V0)^2 / V0.
class RevolvedLiquidTerm final : public EnergyTerm {
 public:
  /// `surface`: its nodes from the pole at +z to that at -z, three to a quadratic piece.
  RevolvedLiquidTerm(const Eigen::Matrix3Xd& rest_um, std::vector<int> surface, double stiffness_uN_per_um2);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;
  bool has_rank_one() const noexcept override { return true; }
  double rank_one(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd& direction) const override;

  /// V = -pi int r^2 dz.
  double volume_um3(const Eigen::Matrix3Xd& x_um) const;
  double rest_volume_um3() const noexcept { return rest_volume_um3_; }
  double pressure_uN_per_um2(const Eigen::Matrix3Xd& x_um) const;

 private:
  RevolvedSurface surface_;
  double stiffness_, rest_volume_um3_ = 0.0;
};

/// A constant pressure that draws a patch of a surface of revolution outward, whichever way that comes to face:
/// U = -p V, V the volume between the patch and the plane of its rim, which must be held along the axis.
class SuctionTerm final : public EnergyTerm {
 public:
  /// `patch`: its nodes from the pole at +z to the rim, three to a quadratic piece.
  explicit SuctionTerm(std::vector<int> patch);
  void set_pressure(double pressure_uN_per_um2) noexcept { pressure_ = pressure_uN_per_um2; }

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

 private:
  RevolvedSurface surface_;
  double pressure_ = 0.0;
};

/// Keeps nodes in the plane y = 0, where nothing else acts, and those of the axis on it, by stiff springs.
class AxisTerm final : public EnergyTerm {
 public:
  AxisTerm(int node_count, std::vector<int> axis, double stiffness_uN_per_um);
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

 private:
  int node_count_;
  std::vector<int> axis_;
  double stiffness_;
  std::vector<BlockSlot> slots_;
};

}  // namespace pellucida
