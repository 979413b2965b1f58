#include "pellucida/membrane/VolumeTerm.h"

#include <Eigen/Geometry>

namespace pellucida {

VolumeTerm::VolumeTerm(const TriangleMesh& rest, double stiffness_uN_per_um2)
    : triangles_(rest.triangles),
      stiffness_uN_per_um2_(stiffness_uN_per_um2),
      rest_volume_um3_(enclosed_volume_um3(rest.points_um, rest.triangles)) {}

void VolumeTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      pairs.emplace_back(triangles_(corner, t), triangles_((corner + 1) % 3, t));
    }
  }
}

double VolumeTerm::rank_one(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd& direction) const {
  direction = gradient_of_volume(x_um);
  return rank_one_factor();
}

void VolumeTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const int a = triangles_(0, t), b = triangles_(1, t), c = triangles_(2, t);
    slots_.push_back({matrix.slot(a, b), matrix.slot(b, c), matrix.slot(c, a)});
  }
}

double VolumeTerm::pressure_uN_per_um2(const Eigen::Matrix3Xd& x_um) const {
  return -stiffness_uN_per_um2_ * (volume_um3(x_um) - rest_volume_um3_) / rest_volume_um3_;
}

Eigen::Matrix3Xd VolumeTerm::gradient_of_volume(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
    const Eigen::Vector3d a = x_um.col(triangles_(0, t));
    const Eigen::Vector3d b = x_um.col(triangles_(1, t));
    const Eigen::Vector3d c = x_um.col(triangles_(2, t));
    gradient.col(triangles_(0, t)) += b.cross(c) / 6.0;
    gradient.col(triangles_(1, t)) += c.cross(a) / 6.0;
    gradient.col(triangles_(2, t)) += a.cross(b) / 6.0;
  }
  return gradient;
}

double VolumeTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  const double change = volume_um3(x_um) - rest_volume_um3_;
  const double slope = stiffness_uN_per_um2_ * change / rest_volume_um3_;
  if (gradient_uN) *gradient_uN += slope * gradient_of_volume(x_um);

  // d2V / dx_a dx_b = -[x_c]x / 6 and its cyclic companions.
  if (hessian) {
    const auto block = [&](int node) {
      const Eigen::Vector3d p = -slope / 6.0 * x_um.col(node);
      Eigen::Matrix3d m;
      m << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
      return m;
    };
    for (Eigen::Index t = 0; t < triangles_.cols(); ++t) {
      const auto& slots = slots_[static_cast<std::size_t>(t)];
      hessian->add(slots[0], block(triangles_(2, t)));
      hessian->add(slots[1], block(triangles_(0, t)));
      hessian->add(slots[2], block(triangles_(1, t)));
    }
  }
  return 0.5 * slope * change;
}

}  // namespace pellucida
