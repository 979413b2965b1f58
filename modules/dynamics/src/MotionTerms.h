#pragma once
#include <vector>

#include "pellucida/membrane/EnergyTerm.h"
#include "pellucida/membrane/SpringTerm.h"

namespace pellucida {

/// Inertia over one implicit step: U = 1/2 c sum |x_i - target_i|^2, c > 0 in uN/um.
class InertiaTerm final : public EnergyTerm {
 public:
  void set(double stiffness_uN_per_um, const Eigen::Matrix3Xd& target_um);

  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

 private:
  double stiffness_uN_per_um_ = 0.0;
  Eigen::Matrix3Xd target_um_;
  std::vector<BlockSlot> slots_;
};

/// The dampers of eq. (1) over one implicit step in which v = v0 + rate (x - x0): U = b / (2 rate) sum (d.v_ij)^2, d
/// the connector's unit direction where the step begins. Its gradient is b (d.v_ij) d.
class DamperTerm final : public EnergyTerm {
 public:
  explicit DamperTerm(const SpringTerm& springs) : springs_(springs) {}

  /// `begin_um` gives the directions; `reference_um` is x0.
  void set(double damping_uN_s_per_um, double rate_per_s, const Eigen::Matrix3Xd& begin_um,
           const Eigen::Matrix3Xd& reference_um, const Eigen::Matrix3Xd& velocity_um_per_s);

  void append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const override;
  void bind(const BlockMatrix& matrix) override;
  double add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const override;

 private:
  struct Slots {
    BlockSlot ii, jj, ij;
  };
  const SpringTerm& springs_;
  double damping_uN_s_per_um_ = 0.0;
  double rate_per_s_ = 1.0;
  Eigen::Matrix3Xd directions_;  // one a spring
  Eigen::Matrix3Xd reference_um_;
  Eigen::Matrix3Xd velocity_um_per_s_;
  std::vector<Slots> slots_;
};

}  // namespace pellucida
