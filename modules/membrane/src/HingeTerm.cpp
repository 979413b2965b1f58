#include "pellucida/membrane/HingeTerm.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pellucida {
namespace {

/// v w^T + w v^T.
Eigen::Matrix3d symmetric_product(const Eigen::Vector3d& v, const Eigen::Vector3d& w) {
  const Eigen::Matrix3d product = v * w.transpose();
  return product + product.transpose();
}

/// One triangle's part of a hinge. With e = b - a, f = c - a, N = e x f, n = N / |N|, the angle's gradient is -q in f
/// and t q in e, where q = |e| / |N| n and t = f.e / |e|^2, the foot of the height.
struct Wing {
  Eigen::Vector3d n;
  Eigen::Vector3d q;
  double t = 0.0;
};

Wing wing(const Eigen::Vector3d& e, double e2, double e_length, const Eigen::Vector3d& f,
          const Eigen::Vector3d& normal) {
  const double length = normal.norm();
  const Eigen::Vector3d n = normal / length;
  return {n, (e_length / length) * n, f.dot(e) / e2};
}

/// The derivatives of a wing's gradient. With m = n x e, p = n x f, k = |e| / |N|^2:
///   ff = k (m n^T + n m^T),  fe = -|q| / |e|^2 n e^T - k (p n^T + n p^T),  ee = s n^T + n s^T,
///   s = m / (2 |e|^3) + t k p,
/// from dn = -(n n^T - I) dN / |N|; of ee the symmetric part, since what is skew in it cancels between the two wings.
struct WingHessian {
  Eigen::Matrix3d ee, fe, ff;
};

WingHessian wing_hessian(const Eigen::Vector3d& e, double e2, double e_length, const Eigen::Vector3d& f,
                         const Wing& w) {
  const double q_length = w.q.norm();
  const double k = q_length * q_length / e_length;
  const Eigen::Vector3d m = w.n.cross(e);
  const Eigen::Vector3d p = k * w.n.cross(f);
  WingHessian hessian;
  hessian.ff = symmetric_product(k * m, w.n);
  hessian.fe = (-q_length / e2 * w.n) * e.transpose() - symmetric_product(p, w.n);
  hessian.ee = symmetric_product(m / (2.0 * e_length * e2) + w.t * p, w.n);
  return hessian;
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
    double bend = theta - hinge.rest_angle_rad;
    if (std::abs(bend) > std::numbers::pi) bend -= std::copysign(2.0 * std::numbers::pi, bend);
    energy += 0.5 * hinge.stiffness_uN_um * bend * bend;
    if (!gradient_uN && !hessian) continue;

    // Gradient of theta in e, f1, f2: those of b, c, d; a's is minus their sum. The second wing's normal runs as f x e,
    // so the formulas for a wing hold for its opposite.
    const Wing w1 = wing(e, e2, e_length, f1, n1);
    const Wing w2 = wing(e, e2, e_length, f2, -n2);
    const Eigen::Vector3d slope_b = w1.t * w1.q - w2.t * w2.q;
    const Eigen::Vector3d slope_c = -w1.q;
    const Eigen::Vector3d slope_d = w2.q;
    const double moment = hinge.stiffness_uN_um * bend;
    if (gradient_uN) {
      gradient_uN->col(hinge.nodes[0]) -= moment * (slope_b + slope_c + slope_d);
      gradient_uN->col(hinge.nodes[1]) += moment * slope_b;
      gradient_uN->col(hinge.nodes[2]) += moment * slope_c;
      gradient_uN->col(hinge.nodes[3]) += moment * slope_d;
    }

    // Stiffness times slope slope^T, plus the moment times the curvature of theta; a's blocks from those of the others,
    // since a translation does nothing.
    if (hessian) {
      const WingHessian h1 = wing_hessian(e, e2, e_length, f1, w1);
      const WingHessian h2 = wing_hessian(e, e2, e_length, f2, w2);
      const double k = hinge.stiffness_uN_um;
      const Eigen::Matrix3d bb = (k * slope_b) * slope_b.transpose() + moment * (h1.ee - h2.ee);
      const Eigen::Matrix3d cb = (k * slope_c) * slope_b.transpose() + moment * h1.fe;
      const Eigen::Matrix3d cc = (k * slope_c) * slope_c.transpose() + moment * h1.ff;
      const Eigen::Matrix3d db = (k * slope_d) * slope_b.transpose() - moment * h2.fe;
      const Eigen::Matrix3d dc = (k * slope_d) * slope_c.transpose();
      const Eigen::Matrix3d dd = (k * slope_d) * slope_d.transpose() - moment * h2.ff;
      const Eigen::Matrix3d ba = -(bb + cb.transpose() + db.transpose());
      const Eigen::Matrix3d ca = -(cb + cc + dc.transpose());
      const Eigen::Matrix3d da = -(db + dc + dd);
      const Eigen::Matrix3d aa = -(ba + ca + da);
      const auto& slots = slots_[n];
      hessian->add(slots[0], aa);
      hessian->add(slots[1], ba);
      hessian->add(slots[2], bb);
      hessian->add(slots[3], ca);
      hessian->add(slots[4], cb);
      hessian->add(slots[5], cc);
      hessian->add(slots[6], da);
      hessian->add(slots[7], db);
      hessian->add(slots[8], dc);
      hessian->add(slots[9], dd);
    }
  }
  return energy;
}

}  // namespace pellucida
