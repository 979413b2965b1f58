#include "pellucida/membrane/SpringTerm.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace pellucida {

SpringTerm::SpringTerm(const TriangleMesh& rest, const std::vector<TrianglePair>& pairs,
                       const SpringConstants& constants) {
  // The X of each triangle pair: the shared edge, and the link between the opposite vertices.
  springs_.reserve(2 * pairs.size());
  for (const auto& pair : pairs) {
    const Eigen::Vector3d a = rest.points_um.col(pair.a), b = rest.points_um.col(pair.b);
    const Eigen::Vector3d c = rest.points_um.col(pair.c), d = rest.points_um.col(pair.d);
    const double pair_area = 0.5 * ((b - a).cross(c - a).norm() + (b - a).cross(d - a).norm());
    springs_.push_back({pair.a, pair.b, (b - a).norm(), pair_area / 6.0, 0.0, 0.0, false});
    springs_.push_back({pair.c, pair.d, (d - c).norm(), pair_area / 6.0, 0.0, 0.0, true});
  }
  set_constants(constants);
}

void SpringTerm::set_constants(const SpringConstants& constants) {
  for (auto& spring : springs_) {
    spring.k2_uN_per_um = 0.5 * (constants.k2_uN_per_um[spring.i] + constants.k2_uN_per_um[spring.j]);
    spring.k1_uN_per_um = 0.5 * (constants.k1_uN_per_um[spring.i] + constants.k1_uN_per_um[spring.j]);
  }
}

void SpringTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (const auto& s : springs_) pairs.emplace_back(s.i, s.j);
}

void SpringTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const auto& s : springs_)
    slots_.push_back({matrix.slot(s.i, s.i), matrix.slot(s.j, s.j), matrix.slot(s.i, s.j)});
}

double SpringTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (std::size_t n = 0; n < springs_.size(); ++n) {
    const Spring& s = springs_[n];
    const Eigen::Vector3d p = x_um.col(s.i) - x_um.col(s.j);
    const double length = p.norm();
    const double e = length / s.rest_length_um - 1.0;
    const double e2 = e * e;
    energy += s.area_um2 * e2 * (0.5 * s.k2_uN_per_um + 0.25 * s.k1_uN_per_um * e2);
    if (!gradient_uN && !hessian) continue;

    // The pull of the connector (uN) along its direction.
    const double scale = s.area_um2 / s.rest_length_um;
    const double pull = s.pull_uN(length);
    const Eigen::Vector3d direction = p / length;
    if (gradient_uN) {
      gradient_uN->col(s.i) += pull * direction;
      gradient_uN->col(s.j) -= pull * direction;
    }

    // Stiffness along the connector, and across it (pull over length).
    if (hessian) {
      const double along = scale / s.rest_length_um * (s.k2_uN_per_um + 3.0 * s.k1_uN_per_um * e2);
      const double across = pull / length;
      Eigen::Matrix3d block = ((along - across) * direction) * direction.transpose();
      block.diagonal().array() += across;
      hessian->add(slots_[n].ii, block);
      hessian->add(slots_[n].jj, block);
      hessian->add(slots_[n].ij, -block);
    }
  }
  return energy;
}

void SpringTerm::add_damping(const Eigen::Matrix3Xd& x_um, const Eigen::Matrix3Xd& velocity_um_per_s,
                             double damping_uN_s_per_um, Eigen::Matrix3Xd& force_uN) const {
  for (const auto& s : springs_) {
    const Eigen::Vector3d p = x_um.col(s.i) - x_um.col(s.j);
    const Eigen::Vector3d v = velocity_um_per_s.col(s.i) - velocity_um_per_s.col(s.j);
    const Eigen::Vector3d f = -damping_uN_s_per_um * v.dot(p) / p.squaredNorm() * p;
    force_uN.col(s.i) += f;
    force_uN.col(s.j) -= f;
  }
}

double SpringTerm::stiffest_uN_per_um() const {
  double stiffest = 0.0;
  for (const auto& s : springs_) {
    stiffest = std::max(stiffest, s.area_um2 * s.k2_uN_per_um / (s.rest_length_um * s.rest_length_um));
  }
  return stiffest;
}

Eigen::VectorXd SpringTerm::tension_uN_per_um(const Eigen::Matrix3Xd& x_um,
                                              const Eigen::VectorXd& node_areas_um2) const {
  Eigen::VectorXd virial = Eigen::VectorXd::Zero(x_um.cols());
  for (const auto& s : springs_) {
    const double length = (x_um.col(s.i) - x_um.col(s.j)).norm();
    const double pull = s.pull_uN(length);
    virial[s.i] += 0.5 * pull * length;
    virial[s.j] += 0.5 * pull * length;
  }
  return (0.5 * virial.array() / node_areas_um2.array()).matrix();
}

}  // namespace pellucida
