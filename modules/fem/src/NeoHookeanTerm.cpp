#include "NeoHookeanTerm.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "pellucida/core/Error.h"

namespace pellucida {
namespace {

/// The deformed edges of one triangle and what follows from them.
struct Edges {
  Eigen::Vector3d d1, d2;
  double g11, g12, g22;
  double gram;  ///< |d1 x d2|^2

  Edges(const Eigen::Matrix3Xd& x_um, const std::array<int, 3>& nodes)
      : d1(x_um.col(nodes[1]) - x_um.col(nodes[0])),
        d2(x_um.col(nodes[2]) - x_um.col(nodes[0])),
        g11(d1.squaredNorm()),
        g12(d1.dot(d2)),
        g22(d2.squaredNorm()),
        gram(d1.cross(d2).squaredNorm()) {}
};

/// ratio^-gamma; the incompressible case is met most and needs no power.
double falling_power(double ratio, double gamma) {
  return gamma == 1.0 ? 1.0 / ratio : std::pow(ratio, -gamma);
}

}  // namespace

NeoHookeanTerm::NeoHookeanTerm(const TriangleMesh& rest, double young_modulus_uN_per_um2, double poisson_ratio,
                               double thickness_um)
    : gamma_(poisson_ratio / (1.0 - poisson_ratio)) {
  if (!(young_modulus_uN_per_um2 > 0.0)) throw UsageError("membrane: Young's modulus must be above 0");
  if (!(thickness_um > 0.0)) throw UsageError("membrane: the thickness must be above 0 um");
  if (!(poisson_ratio > 0.0 && poisson_ratio <= 0.5)) {
    throw UsageError("membrane: Poisson's ratio is " + std::to_string(poisson_ratio) + "; give one above 0, up to 0.5");
  }
  const double shear_modulus = young_modulus_uN_per_um2 / (2.0 * (1.0 + poisson_ratio));
  elements_.reserve(static_cast<std::size_t>(rest.triangles.cols()));
  for (Eigen::Index t = 0; t < rest.triangles.cols(); ++t) {
    Element element;
    for (int corner = 0; corner < 3; ++corner)
      element.nodes[static_cast<std::size_t>(corner)] = rest.triangles(corner, t);
    const Edges e(rest.points_um, element.nodes);
    if (!(e.gram > 0.0)) throw UsageError("membrane: triangle " + std::to_string(t) + " has no area at rest");
    // The inverse of the rest metric.
    element.m11 = e.g22 / e.gram;
    element.m12 = -e.g12 / e.gram;
    element.m22 = e.g11 / e.gram;
    element.gram_um4 = e.gram;
    element.stiffness_uN_um = 0.5 * std::sqrt(e.gram) * thickness_um * 0.5 * shear_modulus;
    elements_.push_back(element);
  }
}

void NeoHookeanTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (const auto& element : elements_) {
    pairs.emplace_back(element.nodes[1], element.nodes[0]);
    pairs.emplace_back(element.nodes[2], element.nodes[0]);
    pairs.emplace_back(element.nodes[2], element.nodes[1]);
  }
}

void NeoHookeanTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const auto& element : elements_) {
    std::array<BlockSlot, 6> slots;
    std::size_t n = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c <= r; ++c) slots[n++] = matrix.slot(element.nodes[r], element.nodes[c]);
    }
    slots_.push_back(slots);
  }
}

double NeoHookeanTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const Element& element = elements_[n];
    const Edges e(x_um, element.nodes);
    const double trace = element.m11 * e.g11 + 2.0 * element.m12 * e.g12 + element.m22 * e.g22;
    const double thinning = falling_power(e.gram / element.gram_um4, gamma_);  // J^(-2 gamma)
    energy += element.stiffness_uN_um * (trace - 2.0 + (thinning - 1.0) / gamma_);
    if (!gradient_uN && !hessian) continue;

    // d|d1 x d2|^2 by each edge, and the derivatives of the energy by that.
    const Eigen::Vector3d gram1 = 2.0 * (e.g22 * e.d1 - e.g12 * e.d2);
    const Eigen::Vector3d gram2 = 2.0 * (e.g11 * e.d2 - e.g12 * e.d1);
    const double stiffness = element.stiffness_uN_um;
    const double slope = -stiffness * thinning / e.gram;

    if (gradient_uN) {
      const Eigen::Vector3d f1 = 2.0 * stiffness * (element.m11 * e.d1 + element.m12 * e.d2) + slope * gram1;
      const Eigen::Vector3d f2 = 2.0 * stiffness * (element.m12 * e.d1 + element.m22 * e.d2) + slope * gram2;
      gradient_uN->col(element.nodes[0]) -= f1 + f2;
      gradient_uN->col(element.nodes[1]) += f1;
      gradient_uN->col(element.nodes[2]) += f2;
    }

    // By the edges: the trace's part is a multiple of the identity; the thinning's has its slope times the curvature of
    // the Gram determinant, and its own curvature times that determinant's slope squared.
    if (hessian) {
      const double curvature = stiffness * (gamma_ + 1.0) * thinning / (e.gram * e.gram);
      const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
      const Eigen::Matrix3d h11 = (2.0 * stiffness * element.m11 + 2.0 * slope * e.g22) * one -
                                  (2.0 * slope * e.d2) * e.d2.transpose() + (curvature * gram1) * gram1.transpose();
      const Eigen::Matrix3d h22 = (2.0 * stiffness * element.m22 + 2.0 * slope * e.g11) * one -
                                  (2.0 * slope * e.d1) * e.d1.transpose() + (curvature * gram2) * gram2.transpose();
      const Eigen::Matrix3d h21 = (2.0 * stiffness * element.m12 - 2.0 * slope * e.g12) * one +
                                  (4.0 * slope * e.d2) * e.d1.transpose() - (2.0 * slope * e.d1) * e.d2.transpose() +
                                  (curvature * gram2) * gram1.transpose();
      const Eigen::Matrix3d h10 = -(h11 + h21.transpose());
      const Eigen::Matrix3d h20 = -(h21 + h22);
      const auto& slots = slots_[n];
      hessian->add(slots[0], -(h10 + h20));
      hessian->add(slots[1], h10);
      hessian->add(slots[2], h11);
      hessian->add(slots[3], h20);
      hessian->add(slots[4], h21);
      hessian->add(slots[5], h22);
    }
  }
  return energy;
}

Eigen::Matrix2Xd NeoHookeanTerm::principal_stretches(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Matrix2Xd stretches(2, static_cast<Eigen::Index>(elements_.size()));
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const Element& element = elements_[n];
    const Edges e(x_um, element.nodes);
    const double half_trace = 0.5 * (element.m11 * e.g11 + 2.0 * element.m12 * e.g12 + element.m22 * e.g22);
    const double determinant = e.gram / element.gram_um4;
    const double spread = std::sqrt(std::max(0.0, half_trace * half_trace - determinant));
    stretches.col(static_cast<Eigen::Index>(n)) << std::sqrt(half_trace + spread),
        std::sqrt(std::max(0.0, half_trace - spread));
  }
  return stretches;
}

}  // namespace pellucida
