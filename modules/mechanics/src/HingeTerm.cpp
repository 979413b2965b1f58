#include "pellucida/mechanics/HingeTerm.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

/// One triangle's part of a hinge. With e = b - a, f = c - a, N = e x f, the angle changes by -q . dx_c and, at a and
/// b, by what the height's foot t leaves to each: q = |e| N / |N|^2, t = f.e / |e|^2, so that d theta = q . ((1 - t)
/// dx_a + t dx_b - dx_c) + (the other triangle's part).
struct Wing {
  Eigen::Vector3d q;
  double t = 0.0;
};

Wing wing(const Eigen::Vector3d& e, double e2, double e_length, const Eigen::Vector3d& f,
          const Eigen::Vector3d& normal) {
  return {e_length / normal.squaredNorm() * normal, f.dot(e) / e2};
}

/// Adds the derivative of a wing's gradient to the hinge's Hessian of theta. `a b c` are the places (0..3) of the
/// wing's nodes.
void add_wing_hessian(const Eigen::Vector3d& e, double e2, double e_length, const Eigen::Vector3d& f,
                      const Eigen::Vector3d& normal, const Wing& w, const std::array<int, 3>& place, double factor,
                      Matrix12& hessian) {
  const double n2 = normal.squaredNorm();
  const Eigen::Vector3d unit = normal / std::sqrt(n2);

  // dq = (e.de / |e|) N / |N|^2 + |e| / |N|^2 (I - 2 n n^T) dN,  dN = de x f + e x df.
  const Eigen::Matrix3d mirror = (e_length / n2) * (Eigen::Matrix3d::Identity() - 2.0 * unit * unit.transpose());
  const Eigen::Matrix3d dq_de = w.q / e2 * e.transpose() - mirror * skew(f);
  const Eigen::Matrix3d dq_df = mirror * skew(e);
  // dt = (e.df + f.de) / |e|^2 - 2 t e.de / |e|^2.
  const Eigen::Vector3d dt_de = (f - 2.0 * w.t * e) / e2;
  const Eigen::Vector3d dt_df = e / e2;

  // In terms of the nodes: e = x_b - x_a, f = x_c - x_a.
  const std::array<Eigen::Matrix3d, 3> dq{-dq_de - dq_df, dq_de, dq_df};
  const std::array<Eigen::Vector3d, 3> dt{-dt_de - dt_df, dt_de, dt_df};
  const std::array<double, 3> share{1.0 - w.t, w.t, -1.0};
  const std::array<double, 3> share_of_t{-1.0, 1.0, 0.0};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      hessian.block<3, 3>(3 * place[r], 3 * place[c]) +=
          factor * (share[r] * dq[c] + (share_of_t[r] * w.q) * dt[c].transpose());
    }
  }
}

}  // namespace

double hinge_angle_rad(const std::array<Eigen::Vector3d, 4>& x_um) {
  const Eigen::Vector3d e = x_um[1] - x_um[0];
  const Eigen::Vector3d n1 = e.cross(x_um[2] - x_um[0]);
  const Eigen::Vector3d n2 = (x_um[3] - x_um[0]).cross(e);
  return std::atan2(n1.cross(n2).dot(e) / e.norm(), n1.dot(n2));
}

HingeTerm::HingeTerm(const TriangleMesh& rest, const std::vector<TrianglePair>& pairs,
                     const Eigen::VectorXd& rigidity_uN_um) {
  hinges_.reserve(pairs.size());
  for (const auto& pair : pairs) {
    const std::array<Eigen::Vector3d, 4> x{rest.points_um.col(pair.a), rest.points_um.col(pair.b),
                                           rest.points_um.col(pair.c), rest.points_um.col(pair.d)};
    const Eigen::Vector3d e = x[1] - x[0];
    const double areas = 0.5 * (e.cross(x[2] - x[0]).norm() + e.cross(x[3] - x[0]).norm());
    hinges_.push_back({{pair.a, pair.b, pair.c, pair.d}, hinge_angle_rad(x), e.squaredNorm() / areas, 0.0});
  }
  set_rigidity(rigidity_uN_um);
}

void HingeTerm::set_rigidity(const Eigen::VectorXd& rigidity_uN_um) {
  for (auto& hinge : hinges_) {
    hinge.stiffness_uN_um = 0.5 * (rigidity_uN_um[hinge.nodes[0]] + rigidity_uN_um[hinge.nodes[1]]) * hinge.shape_ratio;
  }
}

void HingeTerm::append_coupled_nodes(std::vector<std::pair<int, int>>& pairs) const {
  for (const auto& hinge : hinges_) {
    for (int r = 1; r < 4; ++r) {
      for (int c = 0; c < r; ++c) pairs.emplace_back(hinge.nodes[r], hinge.nodes[c]);
    }
  }
}

void HingeTerm::bind(const BlockMatrix& matrix) {
  slots_.clear();
  for (const auto& hinge : hinges_) {
    std::array<BlockSlot, 10> slots;
    std::size_t n = 0;
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c <= r; ++c) slots[n++] = matrix.slot(hinge.nodes[r], hinge.nodes[c]);
    }
    slots_.push_back(slots);
  }
}

double HingeTerm::add(const Eigen::Matrix3Xd& x_um, Eigen::Matrix3Xd* gradient_uN, BlockMatrix* hessian) const {
  double energy = 0.0;
  for (std::size_t n = 0; n < hinges_.size(); ++n) {
    const Hinge& hinge = hinges_[n];
    const Eigen::Vector3d a = x_um.col(hinge.nodes[0]);
    const Eigen::Vector3d e = x_um.col(hinge.nodes[1]) - a;
    const Eigen::Vector3d f1 = x_um.col(hinge.nodes[2]) - a;
    const Eigen::Vector3d f2 = x_um.col(hinge.nodes[3]) - a;
    const Eigen::Vector3d n1 = e.cross(f1);
    const Eigen::Vector3d n2 = f2.cross(e);
    const double e2 = e.squaredNorm();
    const double e_length = std::sqrt(e2);

    // The bend from rest, by the short way round, so that a fold past flat doesn't jump by a turn.
    const double theta = std::atan2(n1.cross(n2).dot(e) / e_length, n1.dot(n2));
    const double bend = std::remainder(theta - hinge.rest_angle_rad, 2.0 * std::numbers::pi);
    energy += 0.5 * hinge.stiffness_uN_um * bend * bend;
    if (!gradient_uN && !hessian) continue;

    // Both wings' gradients of theta.
    const Wing w1 = wing(e, e2, e_length, f1, n1);
    const Wing w2 = wing(e, e2, e_length, f2, n2);
    Vector12 slope;
    slope.segment<3>(0) = (1.0 - w1.t) * w1.q + (1.0 - w2.t) * w2.q;
    slope.segment<3>(3) = w1.t * w1.q + w2.t * w2.q;
    slope.segment<3>(6) = -w1.q;
    slope.segment<3>(9) = -w2.q;
    const double moment = hinge.stiffness_uN_um * bend;
    if (gradient_uN) {
      for (int k = 0; k < 4; ++k) gradient_uN->col(hinge.nodes[k]) += moment * slope.segment<3>(3 * k);
    }

    // Stiffness times slope slope^T, plus the moment times the curvature of theta. The second wing runs its normal as f
    // x e: with N = f2 x e = -(e x f2), its q is minus that of the plain formula, so the plain formula enters with a
    // minus.
    if (hessian) {
      Matrix12 h = (hinge.stiffness_uN_um * slope) * slope.transpose();
      add_wing_hessian(e, e2, e_length, f1, n1, w1, {0, 1, 2}, moment, h);
      const Wing plain{-w2.q, w2.t};
      add_wing_hessian(e, e2, e_length, f2, -n2, plain, {0, 1, 3}, -moment, h);
      std::size_t k = 0;
      for (int r = 0; r < 4; ++r) {
        for (int c = 0; c <= r; ++c) hessian->add(slots_[n][k++], h.block<3, 3>(3 * r, 3 * c));
      }
    }
  }
  return energy;
}

}  // namespace pellucida
