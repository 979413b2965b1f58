#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/TriangleMesh.h"

namespace pellucida {

/// The liquid inside: nearly constant volume, one hydrostatic pressure. U = 1/2 kv (V - V0)^2 / V0, P = -kv (V - V0) /
/// V0. The Hessian is -P grad grad V (sparse, added here) plus kv / V0 (grad V)(grad V)^T, of rank one and full: the
/// solver treats that part separately.
class VolumeTerm final : public EnergyTerm {
 public:
  VolumeTerm(const TriangleMesh& rest, double stiffness_uN_per_um2);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;
  bool has_rank_one() const noexcept override { return true; }
  double rank_one(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd& direction) const override;

  /// grad V, um^2 (3 x n).
  Eigen::Matrix3Xd gradient_of_volume(const Eigen::Matrix3Xd& x_um) const;
  /// kv / V0, uN/um^5.
  double rank_one_factor() const noexcept { return stiffness_uN_per_um2_ / rest_volume_um3_; }

  double volume_um3(const Eigen::Matrix3Xd& x_um) const { return enclosed_volume_um3(x_um, triangles_); }
  double rest_volume_um3() const noexcept { return rest_volume_um3_; }
  /// uN/um^2 (MPa); positive when the liquid pushes outwards.
  double pressure_uN_per_um2(const Eigen::Matrix3Xd& x_um) const;

 private:
  Eigen::Matrix3Xi triangles_;
  double stiffness_uN_per_um2_ = 0.0;
  double rest_volume_um3_ = 0.0;
  std::vector<std::array<BlockSlot, 3>> slots_;
};

}  // namespace pellucida
