#include "pellucida/membrane/NormalObservationTerm.h"

#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {

void NormalObservationTerm::set(std::vector<Observed> observed) {
  for (const Observed& o : observed) {
    if (o.node < 0 || (!diagonal_.empty() && o.node >= static_cast<int>(diagonal_.size()))) {
      throw Error(ExitCode::kOurFault, "observation: node " + std::to_string(o.node) + " isn't one of the model's");
    }
    if (!(std::abs(o.normal.squaredNorm() - 1.0) < 1e-6)) {
      throw Error(ExitCode::kOurFault,
                  "observation: the normal at node " + std::to_string(o.node) + " isn't a unit vector; normalise it");
    }
  }
  observed_ = std::move(observed);
}

void NormalObservationTerm::bind(const BlockMatrix& matrix) {
  diagonal_.clear();
  for (int node = 0; node < matrix.node_count(); ++node) diagonal_.push_back(matrix.slot(node, node));
}

double NormalObservationTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN,
                                  BlockMatrix* hessian) const {
  double energy = 0.0;
  for (const Observed& o : observed_) {
    const double stiffness = o.weight_uN_per_um3 * o.area_um2;
    const double gap = o.normal.dot(x_um.col(o.node) - o.place_um);
    energy += 0.5 * stiffness * gap * gap;
    if (gradient_uN) gradient_uN->col(o.node) += stiffness * gap * o.normal;
    if (hessian) {
      hessian->add(diagonal_[static_cast<std::size_t>(o.node)], (stiffness * o.normal) * o.normal.transpose());
    }
  }
  return energy;
}

double NormalObservationTerm::residual_rms_um(const Eigen::Matrix3Xd& x_um) const {
  double sum = 0.0, area = 0.0;
  for (const Observed& o : observed_) {
    const double gap = o.normal.dot(x_um.col(o.node) - o.place_um);
    sum += o.area_um2 * gap * gap;
    area += o.area_um2;
  }
  return area > 0.0 ? std::sqrt(sum / area) : 0.0;
}

Eigen::Vector3d NormalObservationTerm::force_uN(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const Observed& o : observed_) {
    force -= o.weight_uN_per_um3 * o.area_um2 * o.normal.dot(x_um.col(o.node) - o.place_um) * o.normal;
  }
  return force;
}

}  // namespace pellucida
