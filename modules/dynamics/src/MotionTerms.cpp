#include "MotionTerms.h"

namespace pellucida {

void InertiaTerm::set(double stiffness_uN_per_um, const Eigen::Matrix3Xd& target_um) {
  stiffness_uN_per_um_ = stiffness_uN_per_um;
  target_um_ = target_um;
}

void InertiaTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (int node = 0; node < matrix.node_count(); ++node) slots_.push_back(matrix.slot(node, node));
}

double InertiaTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  if (gradient_uN) *gradient_uN += stiffness_uN_per_um_ * (x_um - target_um_);
  if (hessian) {
    for (const BlockSlot& slot : slots_) hessian->add(slot, stiffness_uN_per_um_ * Eigen::Matrix3d::Identity());
  }
  return 0.5 * stiffness_uN_per_um_ * (x_um - target_um_).squaredNorm();
}

void DamperTerm::set(double damping_uN_s_per_um, double rate_per_s, const Eigen::Matrix3Xd& begin_um,
                     const Eigen::Matrix3Xd& reference_um, const Eigen::Matrix3Xd& velocity_um_per_s) {
  damping_uN_s_per_um_ = damping_uN_s_per_um;
  rate_per_s_ = rate_per_s;
  reference_um_ = reference_um;
  velocity_um_per_s_ = velocity_um_per_s;
  directions_.resize(3, static_cast<Eigen::Index>(springs_.count()));
  Eigen::Index n = 0;
  for (const auto& s : springs_.springs()) directions_.col(n++) = (begin_um.col(s.i) - begin_um.col(s.j)).normalized();
}

void DamperTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  springs_.append_coupled_nodes(pairs);
}

void DamperTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const auto& s : springs_.springs()) {
    slots_.push_back({matrix.slot(s.i, s.i), matrix.slot(s.j, s.j), matrix.slot(s.i, s.j)});
  }
}

double DamperTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  if (damping_uN_s_per_um_ == 0.0) return 0.0;
  double energy = 0.0;
  const auto& springs = springs_.springs();
  for (std::size_t n = 0; n < springs.size(); ++n) {
    const int i = springs[n].i, j = springs[n].j;
    const Eigen::Vector3d d = directions_.col(static_cast<Eigen::Index>(n));
    const Eigen::Vector3d moved = (x_um.col(i) - reference_um_.col(i)) - (x_um.col(j) - reference_um_.col(j));
    const double speed = d.dot(velocity_um_per_s_.col(i) - velocity_um_per_s_.col(j) + rate_per_s_ * moved);
    energy += 0.5 * damping_uN_s_per_um_ / rate_per_s_ * speed * speed;
    if (gradient_uN) {
      gradient_uN->col(i) += damping_uN_s_per_um_ * speed * d;
      gradient_uN->col(j) -= damping_uN_s_per_um_ * speed * d;
    }
    if (hessian) {
      const Eigen::Matrix3d block = (damping_uN_s_per_um_ * rate_per_s_ * d) * d.transpose();
      hessian->add(slots_[n].ii, block);
      hessian->add(slots_[n].jj, block);
      hessian->add(slots_[n].ij, -block);
    }
  }
  return energy;
}

}  // namespace pellucida
