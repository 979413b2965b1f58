#include "pellucida/membrane/EnergyTerm.h"

#include <algorithm>

namespace pellucida {

EnergySum::EnergySum(int node_count, double force_scale_uN_per_um)
    : node_count_(node_count), force_scale_uN_per_um_(force_scale_uN_per_um) {}

void EnergySum::add_term(EnergyTerm& term) {
  terms_.push_back(&term);
  rebind(term);
}

void EnergySum::remove_term(const EnergyTerm& term) {
  std::erase(terms_, &term);
}

void EnergySum::rebind(EnergyTerm& term) {
  if (bound_) term.bind(*bound_);
}

std::vector<std::pair<int, int>> EnergySum::coupled_nodes() const {
  std::vector<std::pair<int, int>> pairs;
  for (const EnergyTerm* term : terms_) term->append_coupled_nodes(pairs);
  return pairs;
}

void EnergySum::bind(const BlockMatrix* matrix) {
  bound_ = matrix;
  for (EnergyTerm* term : terms_) rebind(*term);
}

double EnergySum::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (const EnergyTerm* term : terms_) energy += term->add(x_um, gradient_uN, hessian);
  return energy;
}

}  // namespace pellucida
