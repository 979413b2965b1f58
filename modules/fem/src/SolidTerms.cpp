#include "SolidTerms.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pellucida {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Vector18 = Eigen::Matrix<double, 18, 1>;
using Matrix18 = Eigen::Matrix<double, 18, 18>;

double determinant(const Vector5& f) {
  return (f[0] * f[3] - f[1] * f[2]) * f[4];
}

Vector5 cofactors(const Vector5& f) {
  return {f[3] * f[4], -f[2] * f[4], -f[1] * f[4], f[0] * f[4], f[0] * f[3] - f[1] * f[2]};
}

/// d2 det / df df.
Matrix5 second_cofactors(const Vector5& f) {
  Matrix5 m = Matrix5::Zero();
  m(0, 3) = m(3, 0) = f[4];
  m(1, 2) = m(2, 1) = -f[4];
  m(0, 4) = m(4, 0) = f[3];
  m(1, 4) = m(4, 1) = -f[2];
  m(2, 4) = m(4, 2) = -f[1];
  m(3, 4) = m(4, 3) = f[0];
  return m;
}

}  // namespace

SolidTerm::SolidTerm(const AxisymmetricMesh& mesh, double shear_modulus_uN_per_um2, double lame_uN_per_um2,
                     double stiffening)
    : mu_(shear_modulus_uN_per_um2), lambda_(lame_uN_per_um2), stiffening_(stiffening) {
  for (const auto& nodes : mesh.elements) {
    Element element;
    element.nodes = nodes;
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
    for (std::size_t q = 0; q < 9; ++q) {
      const double xi = kGaussPlace[q % 3], eta = kGaussPlace[q / 3];
      const auto n_xi = quadratic(xi), n_eta = quadratic(eta), d_xi = quadratic_slope(xi), d_eta = quadratic_slope(eta);
      double radius = 0.0;
      Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();  // d(R, Z) / d(xi, eta)
      Eigen::Matrix<double, 2, 9> slope;
      Eigen::Matrix<double, 9, 1> shape;
      for (std::size_t k = 0; k < 9; ++k) {
        const auto at = static_cast<Eigen::Index>(k);
        shape[at] = n_xi[k % 3] * n_eta[k / 3];
        slope.col(at) << d_xi[k % 3] * n_eta[k / 3], n_xi[k % 3] * d_eta[k / 3];
        const Eigen::Vector2d p(mesh.points_um(0, nodes[k]), mesh.points_um(2, nodes[k]));
        jacobian += p * slope.col(at).transpose();
        radius += shape[at] * p.x();
      }
      const Eigen::Matrix<double, 2, 9> gradient = jacobian.inverse().transpose() * slope;
      Point& point = element.points[q];
      point.volume = 2.0 * std::numbers::pi * radius * std::abs(jacobian.determinant()) * kGaussWeight[q % 3] *
                     kGaussWeight[q / 3];
      point.modes << 1.0, xi, eta;
      point.b.setZero();
      for (Eigen::Index k = 0; k < 9; ++k) {
        point.b(0, 2 * k) = gradient(0, k);
        point.b(1, 2 * k) = gradient(1, k);
        point.b(2, 2 * k + 1) = gradient(0, k);
        point.b(3, 2 * k + 1) = gradient(1, k);
        point.b(4, 2 * k) = shape[k] / radius;
      }
      mass += point.volume * point.modes * point.modes.transpose();
    }
    element.inverse_mass = mass.inverse();
    elements_.push_back(element);
  }
}

void SolidTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (const Element& element : elements_) {
    for (std::size_t r = 1; r < 9; ++r) {
      for (std::size_t c = 0; c < r; ++c) pairs.emplace_back(element.nodes[r], element.nodes[c]);
    }
  }
}

void SolidTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const Element& element : elements_) {
    std::array<BlockSlot, 45> slots;
    std::size_t n = 0;
    for (std::size_t r = 0; r < 9; ++r) {
      for (std::size_t c = 0; c <= r; ++c) slots[n++] = matrix.slot(element.nodes[r], element.nodes[c]);
    }
    slots_.push_back(slots);
  }
}

double SolidTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const Element& element = elements_[e];
    Vector18 x;
    for (Eigen::Index k = 0; k < 9; ++k) {
      const int node = element.nodes[static_cast<std::size_t>(k)];
      x.segment<2>(2 * k) << x_um(0, node), x_um(2, node);
    }

    // Strains, and the change of volume in the pressure's modes.
    std::array<Vector5, 9> strain;
    Eigen::Vector3d modes = Eigen::Vector3d::Zero();
    for (std::size_t q = 0; q < 9; ++q) {
      const Point& point = element.points[q];
      strain[q] = point.b * x;
      const double j = determinant(strain[q]);
      if (!(j > 0.0)) return std::numeric_limits<double>::infinity();
      modes += (point.volume * (j - 1.0)) * point.modes;
      const double stretch = strain[q].squaredNorm() - 3.0;
      const double stored = stiffening_ > 0.0 ? std::expm1(stiffening_ * stretch) / stiffening_ : stretch;
      energy += point.volume * 0.5 * mu_ * (stored - 2.0 * std::log(j));
    }
    const Eigen::Vector3d projected = element.inverse_mass * modes;
    energy += 0.5 * lambda_ * modes.dot(projected);
    if (!gradient_uN && !hessian) continue;

    Vector18 slope = Vector18::Zero();
    Matrix18 stiffness = Matrix18::Zero();
    Eigen::Matrix<double, 3, 18> modes_slope = Eigen::Matrix<double, 3, 18>::Zero();
    for (std::size_t q = 0; q < 9; ++q) {
      const Point& point = element.points[q];
      const double j = determinant(strain[q]);
      const Vector5 cofactor = cofactors(strain[q]);
      const double along_j = lambda_ * projected.dot(point.modes) - mu_ / j;
      const double mu = mu_ * std::exp(stiffening_ * (strain[q].squaredNorm() - 3.0));
      slope += point.volume * (point.b.transpose() * (mu * strain[q] + along_j * cofactor));
      if (!hessian) continue;
      Matrix5 tangent = along_j * second_cofactors(strain[q]) + (mu_ / (j * j) * cofactor) * cofactor.transpose();
      tangent.diagonal().array() += mu;
      tangent += (2.0 * stiffening_ * mu * strain[q]) * strain[q].transpose();
      stiffness += point.b.transpose() * (point.volume * tangent * point.b);
      modes_slope += (point.volume * point.modes) * (cofactor.transpose() * point.b);
    }
    if (gradient_uN) {
      for (Eigen::Index k = 0; k < 9; ++k) {
        const int node = element.nodes[static_cast<std::size_t>(k)];
        (*gradient_uN)(0, node) += slope[2 * k];
        (*gradient_uN)(2, node) += slope[2 * k + 1];
      }
    }
    if (hessian) {
      stiffness += lambda_ * modes_slope.transpose() * element.inverse_mass * modes_slope;
      std::size_t n = 0;
      for (Eigen::Index r = 0; r < 9; ++r) {
        for (Eigen::Index c = 0; c <= r; ++c) {
          Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
          block(0, 0) = stiffness(2 * r, 2 * c);
          block(0, 2) = stiffness(2 * r, 2 * c + 1);
          block(2, 0) = stiffness(2 * r + 1, 2 * c);
          block(2, 2) = stiffness(2 * r + 1, 2 * c + 1);
          hessian->add(slots_[e][n++], block);
        }
      }
    }
  }
  return energy;
}

double SolidTerm::largest_volume_change(const Eigen::Matrix3Xd& x_um) const {
  double largest = 0.0;
  for (const Element& element : elements_) {
    double change = 0.0, volume = 0.0;
    for (const Point& point : element.points) {
      Vector18 x;
      for (Eigen::Index k = 0; k < 9; ++k) {
        const int node = element.nodes[static_cast<std::size_t>(k)];
        x.segment<2>(2 * k) << x_um(0, node), x_um(2, node);
      }
      change += point.volume * (determinant(point.b * x) - 1.0);
      volume += point.volume;
    }
    largest = std::max(largest, std::abs(change / volume));
  }
  return largest;
}

void RevolvedSurface::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
    pairs.emplace_back(nodes_[k], nodes_[k + 1]);
    pairs.emplace_back(nodes_[k], nodes_[k + 2]);
    pairs.emplace_back(nodes_[k + 1], nodes_[k + 2]);
  }
}

void RevolvedSurface::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
    std::array<BlockSlot, 6> slots;
    std::size_t n = 0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c <= r; ++c) slots[n++] = matrix.slot(nodes_[k + r], nodes_[k + c]);
    }
    slots_.push_back(slots);
  }
}

namespace {

// A Gauss point of a piece of a surface's meridian: shape functions, their slopes, radius and slope of the height.
struct SurfacePoint {
  std::array<double, 3> shape, slope;
  double r_um = 0.0, dz_um = 0.0;
};

// `q`-th point of the piece whose first node is `nodes[k]`.
SurfacePoint surface_point(const Eigen::Matrix3Xd& x_um, const std::vector<int>& nodes, std::size_t k, std::size_t q) {
  SurfacePoint point{quadratic(kGaussPlace[q]), quadratic_slope(kGaussPlace[q])};
  for (std::size_t n = 0; n < 3; ++n) {
    point.r_um += point.shape[n] * x_um(0, nodes[k + n]);
    point.dz_um += point.slope[n] * x_um(2, nodes[k + n]);
  }
  return point;
}

}  // namespace

double RevolvedSurface::volume_um3(const Eigen::Matrix3Xd& x_um) const {
  double volume = 0.0;
  for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
    for (std::size_t q = 0; q < 3; ++q) {
      const auto [shape, slope, r, dz] = surface_point(x_um, nodes_, k, q);
      volume -= std::numbers::pi * kGaussWeight[q] * r * r * dz;
    }
  }
  return volume;
}

void RevolvedSurface::add_slope(const Eigen::Matrix3Xd& x_um, double factor, Eigen::Matrix3Xd& sum) const {
  for (std::size_t k = 0; k + 2 < nodes_.size(); k += 2) {
    for (std::size_t q = 0; q < 3; ++q) {
      const auto [shape, slope, r, dz] = surface_point(x_um, nodes_, k, q);
      const double weight = -std::numbers::pi * kGaussWeight[q] * factor;
      for (std::size_t n = 0; n < 3; ++n) {
        sum(0, nodes_[k + n]) += weight * 2.0 * r * dz * shape[n];
        sum(2, nodes_[k + n]) += weight * r * r * slope[n];
      }
    }
  }
}

void RevolvedSurface::add_curvature(const Eigen::Matrix3Xd& x_um, double factor, BlockMatrix& hessian) const {
  for (std::size_t k = 0, piece = 0; k + 2 < nodes_.size(); k += 2, ++piece) {
    std::array<Eigen::Matrix3d, 6> blocks;
    blocks.fill(Eigen::Matrix3d::Zero());
    for (std::size_t q = 0; q < 3; ++q) {
      const auto [shape, slope, r, dz] = surface_point(x_um, nodes_, k, q);
      const double weight = -2.0 * std::numbers::pi * kGaussWeight[q] * factor;
      std::size_t n = 0;
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b <= a; ++b, ++n) {
          blocks[n](0, 0) += weight * dz * shape[a] * shape[b];
          blocks[n](0, 2) += weight * r * shape[a] * slope[b];
          blocks[n](2, 0) += weight * r * slope[a] * shape[b];
        }
      }
    }
    for (std::size_t n = 0; n < 6; ++n) hessian.add(slots_[piece][n], blocks[n]);
  }
}

RevolvedLiquidTerm::RevolvedLiquidTerm(const Eigen::Matrix3Xd& rest_um, std::vector<int> surface,
                                       double stiffness_uN_per_um2)
    : surface_(std::move(surface)), stiffness_(stiffness_uN_per_um2) {
  rest_volume_um3_ = volume_um3(rest_um);
}

void RevolvedLiquidTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  surface_.append_coupled_nodes(pairs);
}

void RevolvedLiquidTerm::bind(const BlockMatrix& matrix) {
  surface_.bind(matrix);
}

double RevolvedLiquidTerm::volume_um3(const Eigen::Matrix3Xd& x_um) const {
  return surface_.volume_um3(x_um);
}

double RevolvedLiquidTerm::pressure_uN_per_um2(const Eigen::Matrix3Xd& x_um) const {
  return -stiffness_ * (volume_um3(x_um) - rest_volume_um3_) / rest_volume_um3_;
}

double RevolvedLiquidTerm::rank_one(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd& direction) const {
  direction = Eigen::Matrix3Xd::Zero(3, x_um.cols());
  surface_.add_slope(x_um, 1.0, direction);
  return stiffness_ / rest_volume_um3_;
}

double RevolvedLiquidTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN,
                               BlockMatrix* hessian) const {
  const double change = volume_um3(x_um) - rest_volume_um3_;
  const double factor = stiffness_ * change / rest_volume_um3_;
  if (gradient_uN) surface_.add_slope(x_um, factor, *gradient_uN);
  if (hessian) surface_.add_curvature(x_um, factor, *hessian);
  return 0.5 * factor * change;
}

SuctionTerm::SuctionTerm(std::vector<int> patch) : surface_(std::move(patch)) {}

void SuctionTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  surface_.append_coupled_nodes(pairs);
}

void SuctionTerm::bind(const BlockMatrix& matrix) {
  surface_.bind(matrix);
}

double SuctionTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  if (gradient_uN) surface_.add_slope(x_um, -pressure_, *gradient_uN);
  if (hessian) surface_.add_curvature(x_um, -pressure_, *hessian);
  return -pressure_ * surface_.volume_um3(x_um);
}

AxisTerm::AxisTerm(int node_count, std::vector<int> axis, double stiffness_uN_per_um)
    : node_count_(node_count), axis_(std::move(axis)), stiffness_(stiffness_uN_per_um) {}

void AxisTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (int n = 0; n < node_count_; ++n) slots_.push_back(matrix.slot(n, n));
}

double AxisTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.5 * stiffness_ * x_um.row(1).squaredNorm();
  if (gradient_uN) gradient_uN->row(1) += stiffness_ * x_um.row(1);
  for (const int n : axis_) {
    energy += 0.5 * stiffness_ * x_um(0, n) * x_um(0, n);
    if (gradient_uN) (*gradient_uN)(0, n) += stiffness_ * x_um(0, n);
  }
  if (hessian) {
    for (const BlockSlot& slot : slots_)
      hessian->add(slot, Eigen::Vector3d(0.0, stiffness_, 0.0).asDiagonal().toDenseMatrix());
    for (const int n : axis_) {
      hessian->add(slots_[static_cast<std::size_t>(n)],
                   Eigen::Vector3d(stiffness_, 0.0, 0.0).asDiagonal().toDenseMatrix());
    }
  }
  return energy;
}

}  // namespace pellucida
