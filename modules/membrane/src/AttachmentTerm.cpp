#include "pellucida/membrane/AttachmentTerm.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace pellucida {

AttachmentTerm::AttachmentTerm(const Eigen::Matrix3Xd& rest_um, const Eigen::VectorXd& weights_uN_per_um) {
  // Most nodes carry nothing: keep those that do.
  for (Eigen::Index n = 0; n < weights_uN_per_um.size(); ++n) {
    if (weights_uN_per_um[n] <= 0.0) continue;
    nodes_.push_back(static_cast<int>(n));
    weights_.push_back(weights_uN_per_um[n]);
  }
  rest_um_.resize(3, static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t k = 0; k < nodes_.size(); ++k) rest_um_.col(static_cast<Eigen::Index>(k)) = rest_um.col(nodes_[k]);
}

void AttachmentTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const int node : nodes_) slots_.push_back(matrix.slot(node, node));
}

double AttachmentTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d gap = x_um.col(nodes_[k]) - rest_um_.col(static_cast<Eigen::Index>(k)) - displacement_um_;
    energy += 0.5 * weights_[k] * gap.squaredNorm();
    if (gradient_uN) gradient_uN->col(nodes_[k]) += weights_[k] * gap;
    if (hessian) hessian->add(slots_[k], weights_[k] * Eigen::Matrix3d::Identity());
  }
  return energy;
}

Eigen::Vector3d AttachmentTerm::force_uN(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    force += weights_[k] * (rest_um_.col(static_cast<Eigen::Index>(k)) + displacement_um_ - x_um.col(nodes_[k]));
  }
  return force;
}

Eigen::Vector3d AttachmentTerm::moment_uN_um(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Eigen::Vector3d x = x_um.col(nodes_[k]);
    moment += x.cross(weights_[k] * (rest_um_.col(static_cast<Eigen::Index>(k)) + displacement_um_ - x));
  }
  return moment;
}

Eigen::Vector3d AttachmentTerm::mean_displacement_um(const Eigen::Matrix3Xd& x_um) const {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    mean += weights_[k] * (x_um.col(nodes_[k]) - rest_um_.col(static_cast<Eigen::Index>(k)));
    total += weights_[k];
  }
  return total > 0.0 ? Eigen::Vector3d(mean / total) : Eigen::Vector3d::Zero();
}

namespace {

/// Integrates density(point) times the shape functions over the sphere: each triangle in parts x parts small ones, each
/// taken at its middle, moved out onto the sphere. `may_matter` spares triangles that can't carry density.
Eigen::VectorXd integrate(const TriangleMesh& sphere, double radius_um,
                          const std::function<bool(const Eigen::Vector3d&, double)>& may_matter,
                          const std::function<double(const Eigen::Vector3d&)>& density) {
  constexpr int kParts = 24;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(sphere.points_um.cols());
  for (Eigen::Index t = 0; t < sphere.triangles.cols(); ++t) {
    const Eigen::Vector3d a = sphere.points_um.col(sphere.triangles(0, t));
    const Eigen::Vector3d b = sphere.points_um.col(sphere.triangles(1, t));
    const Eigen::Vector3d c = sphere.points_um.col(sphere.triangles(2, t));
    const Eigen::Vector3d middle = (a + b + c) / 3.0;
    const double reach = std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()});
    if (!may_matter(middle, reach)) continue;

    const double part_area = 0.5 * (b - a).cross(c - a).norm() / (kParts * kParts);
    for (int i = 0; i < kParts; ++i) {
      for (int j = 0; j < kParts - i; ++j) {
        // An upright small triangle, and but for the last of the row an inverted one.
        for (int inverted = 0; inverted < (j < kParts - i - 1 ? 2 : 1); ++inverted) {
          const double third = inverted ? 2.0 / 3.0 : 1.0 / 3.0;
          const double beta = (i + third) / kParts, gamma = (j + third) / kParts, alpha = 1.0 - beta - gamma;
          const Eigen::Vector3d p = alpha * a + beta * b + gamma * c;
          const double amount = density(p.normalized() * radius_um) * part_area;
          weights[sphere.triangles(0, t)] += amount * alpha;
          weights[sphere.triangles(1, t)] += amount * beta;
          weights[sphere.triangles(2, t)] += amount * gamma;
        }
      }
    }
  }
  return weights;
}

/// The facets are a little smaller than the sphere: the closed-form total is put back.
Eigen::VectorXd with_total(Eigen::VectorXd weights, double total) {
  const double sum = weights.sum();
  if (sum > 0.0) weights *= total / sum;
  return weights;
}

}  // namespace

Eigen::VectorXd tip_weights_uN_per_um(const TriangleMesh& sphere, const Eigen::Vector3d& contact, double tip_radius_um,
                                      double density_uN_per_um3) {
  const double radius = sphere.points_um.col(0).norm();
  const Eigen::Vector3d centre = radius * contact;
  const auto may_matter = [&](const Eigen::Vector3d& middle, double reach) {
    return (middle.normalized() * radius - centre).norm() < tip_radius_um + 1.5 * reach;
  };
  const auto density = [&](const Eigen::Vector3d& p) {
    return density_uN_per_um3 * std::max(0.0, 1.0 - (p - centre).squaredNorm() / (tip_radius_um * tip_radius_um));
  };
  return with_total(integrate(sphere, radius, may_matter, density),
                    0.5 * std::numbers::pi * tip_radius_um * tip_radius_um * density_uN_per_um3);
}

Eigen::VectorXd holder_weights_uN_per_um(const TriangleMesh& sphere, const Eigen::Vector3d& direction, double ring_um,
                                         double half_width_um, double density_uN_per_um3) {
  const double radius = sphere.points_um.col(0).norm();
  const auto may_matter = [&](const Eigen::Vector3d& middle, double reach) {
    const double along = middle.dot(direction);
    const double rho = std::sqrt(std::max(0.0, middle.squaredNorm() - along * along));
    return along > -reach && rho < ring_um + half_width_um + 1.5 * reach;
  };
  const auto density = [&](const Eigen::Vector3d& p) {
    const double along = p.dot(direction);
    if (along <= 0.0) return 0.0;
    const double offset = (std::sqrt(std::max(0.0, radius * radius - along * along)) - ring_um) / half_width_um;
    return density_uN_per_um3 * std::max(0.0, 1.0 - offset * offset);
  };

  // Total over the sphere: rho = R sin(theta), by Simpson's rule.
  const double low = std::max(0.0, ring_um - half_width_um);
  const double high = std::min(radius * 0.999, ring_um + half_width_um);
  constexpr int kSteps = 200;
  double total = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    const double rho = low + (high - low) * k / kSteps;
    const double offset = (rho - ring_um) / half_width_um;
    const double value =
        (1.0 - offset * offset) * 2.0 * std::numbers::pi * rho / std::sqrt(1.0 - rho * rho / (radius * radius));
    total += value * (k == 0 || k == kSteps ? 1.0 : k % 2 ? 4.0 : 2.0);
  }
  total *= density_uN_per_um3 * (high - low) / (3.0 * kSteps);
  return with_total(integrate(sphere, radius, may_matter, density), total);
}

}  // namespace pellucida
